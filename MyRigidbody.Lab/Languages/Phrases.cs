using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>The words of plans, integrators and effects, part by part, with their Chinese.</summary>
internal static class Phrases
{
    public sealed record Part(Regex Pattern, string Chinese);

    /// <summary>In the order of the search: longer parts before those that they contain.</summary>
    public static readonly IReadOnlyList<Part> Known =
    [
        .. new (string English, string Chinese)[]
        {
            // parts of a motion
            ("^drift$", "按速度移动"),
            ("^rest$", "静止"),
            (@"(?<=\b[xyz]) and (?=[xyz]\b)", "、"),
            (@"^drift along (.*)$", "沿 $1 轴移动"),
            (@"^motion along (.*)$", "沿 $1 轴的移动"),
            (@"^rotation about (.*) \(exact\)$", "绕 $1 轴转动（精确）"),
            (@"^rotation about (.*)$", "绕 $1 轴的转动"),
            ("^locked$", "已锁定"),
            (@" \(closed form\)$", "（闭式解）"),
            (@"^free rotation of a body with three different moments \(exact\)$", "自由转动，三个主转动惯量各不相同（精确）"),
            (@"^free rotation of a body with two equal moments \(exact\)$", "自由转动，两个主转动惯量相等（精确）"),
            (@"^free rotation of a body with three equal moments \(exact\)$", "自由转动，三个主转动惯量相等（精确）"),
            (@"^free rotation, split into three \(order 2\)$", "自由转动，分成三个转动（二阶）"),
            ("^rotation as in PhysX with its gyroscopic option$", "与 PhysX 相同的转动，打开陀螺项"),
            (@"^rotation by (\w+)", "按 $1 转动"),
            (@" \(no gyroscopic term\)$", "（无陀螺项）"),
            ("^no rotation$", "不转动"),
            ("^turned by the whole angle ω Δt$", "按整个角度 ω Δt 转动"),
            (@", turned by q \+ \[0, ½Δt ω\] q$", "，用 q + [0, ½Δt ω] q 转动"),
            (@"^drag (\S+) /s, angularDrag (\S+) /s, limit (\S+) rad/s, sleep below (\S+) J/kg of the velocity summed over 0\.2 s$",
                "drag $1 /s，angularDrag $2 /s，角速度上限 $3 rad/s，0.2 s 内速度之和低于 $4 J/kg 时休眠"),

            // effects
            (@"^mass (\S+) kg/s, velocity kept$", "质量变化率 $1 kg/s，速度不变"),
            (@"^mass (\S+) kg/s, momentum kept$", "质量变化率 $1 kg/s，动量不变"),
            (@"^impulse (.*), body axes, at once$", "冲量 $1，刚体坐标轴，瞬时"),
            (@"^impulse (.*), at once$", "冲量 $1，瞬时"),
            (@"(?<= N s)(.*) and (.*) N m s", "$1，角冲量 $2 N m s"),
            (@"(?<= N s) at (.*) m of the body", "，作用于刚体上的点 $1 m"),
            (@"\bgravity\b", "重力"),
            (@"\bangular damping\b", "角速度阻尼"),
            (@"\blinear damping\b", "速度阻尼"),
            (@"^v × (\S+), ω × (\S+) a step", "每步 v × $1、ω × $2"),
            (@"^force (.*) N at (.*) m of the body, body axes$", "力 $1 N，作用于刚体上的点 $2 m，刚体坐标轴"),
            (@"^force (.*) N at (.*) m of the body$", "力 $1 N，作用于刚体上的点 $2 m"),
            (@"^force (.*) N, body axes$", "力 $1 N，刚体坐标轴"),
            (@"\bforce (?=\()", "力 "),
            ("^torque (.*), world axes$", "力矩 $1，世界坐标轴"),
            ("^torque (.*), body axes$", "力矩 $1，刚体坐标轴"),
            (@"\bkey R\b", "r 键"),
            (@"\bkey LeftArrow\b", "左方向键"),
            (@"\bkey RightArrow\b", "右方向键"),
            (@"\bkey UpArrow\b", "上方向键"),
            (@"\bkey DownArrow\b", "下方向键"),
            ("^keys held on the keyboard$", "键盘上按住的键"),
            (@"^a force for each of (\d+) steps, a torque for each of (\d+)$", "$1 步中每步一个力，$2 步中每步一个力矩"),
            (@"^drag (\S+) abs\(v\) v N$", "阻力 $1 abs(v) v N"),
            ("^spring (.*) from (.*) to (.*)$", "弹簧 $1，从 $2 到 $3"),
            ("^heavy top, m g l = (.*) along (.*), up (.*)$", "重陀螺，m g l = $1，沿 $2，向上为 $3"),

            // when
            ("^always$", "始终"),
            (@"^from (\S+ s)$", "从 $1 起"),
            (@"^(\S+ s) to (\S+ s)$", "$1 至 $2"),

            // what is left out, and why
            ("^steps whose states are not read$", "不读取其状态的步"),
            (@"^closed form: always$", "始终有闭式解"),
            (@"^closed form: from (\S+ s)$", "从 $1 起有闭式解"),
            (@"^closed form: (\S+ s) to (\S+ s)$", "$1 至 $2 有闭式解"),
            ("^rotation$", "转动"),
            ("^translation$", "平动"),
            ("^it starts without angular velocity and no torque acts$", "初始角速度为零，也没有力矩"),
            ("^it starts at rest and nothing moves it$", "初始静止，也没有力"),
            ("^the scene says that it cannot turn$", "场景规定它不能转动"),
            ("^the scene says that it cannot move$", "场景规定它不能移动"),
            ("^the general free rotation$", "一般的自由转动"),
            ("^all moments are equal, so ω stays$", "主转动惯量都相等，ω 不变"),
            ("^two moments are equal, so two turns are enough$", "两个主转动惯量相等，两次转动就够了"),
            ("^damping$", "阻尼"),
            ("^drag$", "空气阻力"),
            ("^forces and torques$", "力和力矩"),
            ("^none in the scene$", "场景中没有"),
            (@": swings are stable in steps below (\S+) s", "：步长小于 $1 s 时摆动稳定"),
            (@", and the scene's is (\S+) s$", "，而场景的步长为 $1 s"),

            // rules of a comparison
            ("^integrator$", "积分器"),
            ("^inertia$", "转动惯量"),
            ("^limit of spin$", "角速度上限"),
            ("^orientation$", "朝向"),
            ("^sleep$", "休眠"),
            ("^gyroscopic forces$", "陀螺力"),
            ("^scene$", "场景"),
            ("^precision$", "精度"),
            ("^position$", "位置"),
            ("^velocity$", "速度"),
            ("^angular velocity$", "角速度"),
            ("^none$", "无"),
            ("^never$", "从不"),
            ("^no rad/s$", "无上限"),
            ("^double$", "双精度"),
            ("^single$", "单精度"),
            ("^the lab's steps, no ω × I ω$", "实验的步骤，没有 ω × I ω"),
            ("^the exact turn about ω$", "绕 ω 的精确转动"),
            (@"^below (\S+ J/kg), velocities of 0\.2 s summed$", "0.2 s 内速度之和低于 $1"),
            ("^PhysX 5's$", "PhysX 5 的规则"),
            ("^nothing acts$", "没有作用"),
            (@", mine / (\S+)$", "，为前者的 1/$1"),
            (@", mine × (\S+)$", "，为前者的 $1 倍"),
        }.Select(pair => new Part(new Regex(pair.English, RegexOptions.CultureInvariant), pair.Chinese)),
    ];
}
