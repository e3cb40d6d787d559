using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The sentence of help for each kind of finding, in English and Chinese.</summary>
    internal static class Words
    {
        private static readonly Dictionary<string, string[]> Sentences = new Dictionary<string, string[]>
        {
            ["not-done"] = new[] { "nothing is done here", "这一步没有做" },
            ["v-not-a-number"] = new[] { "v becomes NaN; look for a division by zero", "v 变成了 NaN，请检查是否除以了零" },
            ["v-sometimes"] = new[] { "right in most frames, but not in all; look at the frame named", "多数帧正确，但并非每一帧都正确，请看所指出的那一帧" },
            ["v-formula"] = new[] { "what is added to v is not Δt F/m", "v 的增量不是 Δt F/m" },
            ["v-assigned"] = new[] { "v is set and not added to; what it was before is lost", "v 被直接赋值而没有累加，原来的速度丢失了" },
            ["v-sign"] = new[] { "the force pulls the wrong way: the sign is turned round", "力的方向反了，符号有误" },
            ["v-no-dt"] = new[] { "Δt is missing: v grows by a whole second's acceleration in every frame", "漏乘了 Δt，每一帧都按一整秒加速" },
            ["time-for-dt"] = new[] { "the time since the start stands in the place of Δt", "把开始以来的时间 Time.time 当成了 Δt" },
            ["mass-multiplied"] = new[] { "the force is multiplied by the mass and not divided by it", "力乘了质量，应当除以质量" },
            ["mass-not-used"] = new[] { "the mass is not used; it shows as soon as the mass is not 1 kg", "没有用到质量，质量不为 1 kg 时就会出错" },
            ["mass-twice"] = new[] { "the force is divided by the mass twice", "力被质量除了两次" },
            ["v-dt-twice"] = new[] { "Δt is multiplied in twice", "多乘了一次 Δt" },
            ["two-time-steps"] = new[] { "this step takes another Δt than the others; at 50 frames a second it cannot be seen", "这一步的 Δt 与其他步骤不同，每秒 50 帧时看不出来" },
            ["v-factor"] = new[] { "what is added to v is not Δt F/m but a multiple of it", "v 的增量不是 Δt F/m，而是它的若干倍" },
            ["force-in-body-axes"] = new[] { "the force is turned with the body; the keys push along the axes of the world", "力随物体一起转动了，按键的力应沿世界坐标轴" },
            ["w-not-a-number"] = new[] { "ω becomes NaN; look for a division by zero or a matrix without an inverse", "ω 变成了 NaN，请检查是否除以了零，或矩阵不可逆" },
            ["w-sometimes"] = new[] { "right in most frames, but not in all; look at the frame named", "多数帧正确，但并非每一帧都正确，请看所指出的那一帧" },
            ["w-formula"] = new[] { "what is added to ω is not Δt I⁻¹ τ with I = R I_ref Rᵀ", "ω 的增量不是 Δt I⁻¹ τ（其中 I = R I_ref Rᵀ）" },
            ["w-assigned"] = new[] { "ω is set and not added to; what it was before is lost", "ω 被直接赋值而没有累加，原来的角速度丢失了" },
            ["w-sign"] = new[] { "the torque turns the wrong way: the sign is turned round", "力矩的方向反了，符号有误" },
            ["w-no-dt"] = new[] { "Δt is missing: ω grows by a whole second's acceleration in every frame", "漏乘了 Δt，每一帧都按一整秒加速" },
            ["w-dt-twice"] = new[] { "Δt is multiplied in twice", "多乘了一次 Δt" },
            ["w-factor"] = new[] { "what is added to ω is a multiple of Δt I⁻¹ τ", "ω 的增量是 Δt I⁻¹ τ 的若干倍" },
            ["w-mass-multiplied"] = new[] { "the mass is multiplied in; it is in I_ref already", "多乘了质量，质量已经包含在 I_ref 中" },
            ["w-mass-divided"] = new[] { "the mass is divided by; it is in I_ref already", "多除了质量，质量已经包含在 I_ref 中" },
            ["inertia-not-turned"] = new[] { "I_ref is used as it is; once the body has turned it is R I_ref Rᵀ that counts", "直接用了 I_ref，物体转动后应使用 R I_ref Rᵀ" },
            ["torque-as-acceleration"] = new[] { "the torque is taken for the angular acceleration; the inertia is not used", "把力矩当成了角加速度，没有用到转动惯量" },
            ["not-inverted"] = new[] { "I multiplies the torque and its inverse should", "力矩乘的是 I，应当乘 I 的逆" },
            ["turned-the-wrong-way"] = new[] { "R and its transpose have changed places", "R 与它的转置位置颠倒了" },
            ["transpose-missing"] = new[] { "one R is not transposed", "缺少转置，两个 R 中应有一个是转置" },
            ["turned-on-one-side"] = new[] { "R stands on one side of I_ref only", "R 只乘在了 I_ref 的一侧" },
            ["only-the-diagonal"] = new[] { "only the diagonal of I is used", "只用了 I 的对角线元素" },
            ["torque-turned"] = new[] { "the torque is turned and the inertia is not used", "只旋转了力矩，没有用到转动惯量" },
            ["gyroscopic-term"] = new[] { "the term ω × (I ω) is added, which the sheet leaves out", "加上了 ω × (I ω) 一项，实验讲义中没有这一项" },
            ["x-not-a-number"] = new[] { "x becomes NaN", "位置变成了 NaN" },
            ["x-sometimes"] = new[] { "right in most frames, but not in all; look at the frame named", "多数帧正确，但并非每一帧都正确，请看所指出的那一帧" },
            ["x-formula"] = new[] { "the body does not move by Δt v", "物体的位移不是 Δt v" },
            ["x-assigned"] = new[] { "the position is set and not added to; the body stays near the origin", "位置被直接赋值而没有累加，物体停在原点附近" },
            ["x-in-body-axes"] = new[] { "the body moves along its own axes and not along those of the world", "沿物体自身的坐标轴移动了，应沿世界坐标轴" },
            ["x-acceleration"] = new[] { "the acceleration is counted in once more, beside v", "除速度外又多算了一次加速度" },
            ["x-second-order"] = new[] { "the mean of old and new velocity moves the body: more exact than the sheet's formula, and not the sheet's formula", "用了新旧速度的平均值，比讲义的公式更精确，但不是讲义的公式" },
            ["starts-elsewhere"] = new[] { "the body jumps in the first frame: the script's own position does not start where the object is", "第一帧物体就跳走了，脚本自己的位置没有从物体的位置开始" },
            ["x-no-dt"] = new[] { "Δt is missing: the body moves by a whole second's way in every frame", "漏乘了 Δt，每一帧都移动了一整秒的路程" },
            ["x-sign"] = new[] { "the body moves backwards: the sign is turned round", "运动方向反了，符号有误" },
            ["x-twice"] = new[] { "the body moves twice as far as it should", "位移是应有的 2 倍" },
            ["x-half"] = new[] { "the body moves half as far as it should", "位移只有应有的一半" },
            ["x-dt-twice"] = new[] { "Δt is multiplied in twice", "多乘了一次 Δt" },
            ["x-factor"] = new[] { "the body moves by a multiple of Δt v", "位移是 Δt v 的若干倍" },
            ["q-not-a-number"] = new[] { "the orientation becomes NaN; look for a division by the length of a zero vector", "朝向变成了 NaN，请检查是否除以了零向量的长度" },
            ["q-sometimes"] = new[] { "right in most frames, but not in all; look at the frame named", "多数帧正确，但并非每一帧都正确，请看所指出的那一帧" },
            ["q-formula"] = new[] { "the turn is not that of q + [0, ½Δt ω] q", "转动不符合 q + [0, ½Δt ω] q" },
            ["half-missing"] = new[] { "the turn is 2 times what it should be: the ½ is missing", "转角是应有的 2 倍，漏了 ½" },
            ["half-twice"] = new[] { "the turn is half of what it should be: the ½ counts twice", "转角只有应有的一半，½ 乘了两次" },
            ["order-of-product"] = new[] { "the factors of the quaternion product have changed places: the body turns about its own axes", "四元数乘法的次序颠倒了，物体绕自身的轴转动" },
            ["rotate-degrees"] = new[] { "an angle in radians is given where Unity takes degrees", "Unity 在这里要求角度制，却给了弧度" },
            ["rotate-in-body-axes"] = new[] { "the body turns about its own axes and not about those of the world", "绕物体自身的轴转动了，应绕世界坐标轴" },
            ["euler-angles"] = new[] { "Euler angles are added to; they do not add up like vectors", "对欧拉角做了累加，欧拉角不能像向量那样相加" },
            ["euler-turn"] = new[] { "the turn is made of Euler angles: right for a small turn, and not the sheet's formula", "用欧拉角构造了转动，转角小时近似正确，但不是讲义的公式" },
            ["exact-turn"] = new[] { "the turn is by the exact angle: more exact than the sheet's formula, and not the sheet's formula", "用了精确转角，比讲义的公式更精确，但不是讲义的公式" },
            ["not-normalised"] = new[] { "the script's own quaternion is never brought back to length 1; it grows, and R is no rotation any more", "脚本自己的四元数没有归一化，长度越来越大，R 不再是旋转矩阵" },
            ["q-second-order"] = new[] { "the mean of old and new angular velocity turns the body, and not one of the two", "用了新旧角速度的平均值，而不是其中之一" },
            ["q-left-out"] = new[] { "[0, ½Δt ω] is added without being multiplied by q", "加上的是 [0, ½Δt ω]，漏乘了 q" },
            ["q-assigned"] = new[] { "q is set and not added to", "q 被直接赋值而没有累加" },
            ["quaternion-arguments"] = new[] { "the components stand in the wrong order: Unity takes x, y, z, w", "四元数分量的次序有误，Unity 的次序是 x, y, z, w" },
            ["q-sign"] = new[] { "the body turns backwards: the sign is turned round", "转动方向反了，符号有误" },
            ["q-no-dt"] = new[] { "Δt is missing: the body turns by a whole second's angle in every frame", "漏乘了 Δt，每一帧都转过了一整秒的角度" },
            ["q-to-degrees"] = new[] { "an angle in degrees is used where radians belong", "应使用弧度的地方用了角度" },
            ["q-dt-twice"] = new[] { "Δt is multiplied in twice", "多乘了一次 Δt" },
            ["q-factor"] = new[] { "the turn is a multiple of what it should be", "转角是应有的若干倍" },
            ["damped-twice"] = new[] { "v and ω are multiplied by 0.98 twice in a frame", "每一帧衰减了两次" },
            ["v-not-damped"] = new[] { "ω is damped and v is not", "只衰减了 ω，没有衰减 v" },
            ["w-not-damped"] = new[] { "v is damped and ω is not", "只衰减了 v，没有衰减 ω" },
            ["damped-only-when-let-go"] = new[] { "damped only while no key is held", "只在没有按键时衰减" },
            ["damped-only-when-pushed"] = new[] { "damped only while a key is held", "只在按键时衰减" },
            ["damped-before-moving"] = new[] { "damped before the body is moved: it goes 98 % of the way", "在移动物体之前就衰减了，位移只有应有的 98 %" },
            ["damping-times-dt"] = new[] { "the factor is multiplied by Δt", "衰减系数多乘了 Δt" },
            ["damping-as-rate"] = new[] { "the damping follows the time and not the frame: 0.98 at 50 frames a second, another factor at others", "衰减按时间而不是按帧计算，每秒 50 帧时为 0.98，其他帧率下不同" },
            ["damped-by-the-loss"] = new[] { "multiplied by what should be lost, 0.02, and not by what should stay", "乘的是应损失的 0.02，而不是应保留的 0.98" },
            ["damped-sometimes"] = new[] { "damped in some frames only", "只在部分帧衰减" },
            ["other-factor"] = new[] { "the factor is not 0.98", "衰减系数不是 0.98" },
            ["damping-formula"] = new[] { "what v and ω lose in a frame is not 2 %", "v 与 ω 每帧的损失不是 2 %" },
            ["force-changed"] = new[] { "the keys' force is not as it was handed out", "按键的力与下发的代码不同" },
            ["torque-changed"] = new[] { "the torque of the key R is not as it was handed out", "R 键的力矩与下发的代码不同" },
            ["inertia-changed"] = new[] { "I_ref after Start is not Σ m (r·r 1 − r rᵀ) of the vertices", "Start 之后的 I_ref 不等于各顶点的 Σ m (r·r 1 − r rᵀ)" },
        };

        public static Finding Finding(Step step, string code, string expected, string found)
        {
            string[] sentence = Sentences[code];
            bool isGiven = step == Step.Given;
            return new Finding(
                step, code, expected, found, (isGiven ? "Given code: " : $"Step {(int)step}: ") + sentence[0] + ".", (isGiven ? "给定代码：" : $"第 {(int)step} 步：") + sentence[1] + "。");
        }
    }
}
