namespace RigidBodyDynamics.Tests;

/// <summary>The Chinese texts of the page of hard cases, by the case's name.</summary>
internal static class HardCaseWords
{
    private const string LastBits = "以输入数据的末位为单位", Not = "未测";

    /// <summary>The claim, the measure, and the results of other programs.</summary>
    public static IReadOnlyDictionary<string, (string Name, string Figure, string Elsewhere)> InChinese { get; } = new Dictionary<string, (string, string, string)>
    {
        ["Needle_one_to_a_million_is_where_it_should_be"] = ("百万比一的细针处在应在的朝向", "10 s 内的最大夹角，" + LastBits, "步长固定的引擎都在 0.5 s 内偏差 0.1 rad"),
        ["Needle_keeps_its_nutation"] = ("细针保持章动", "60 s 内与轴垂直的 ω² 的变化", "Bullet、MuJoCo implicit 和 RK4：章动消失；PhysX、Jolt、Rapier：能量降到 0.034"),
        ["Spin_of_ten_thousand_rad_a_second_is_followed_at_ten_rad_a_step"] = ("每秒一万弧度的自转，每步十弧度也算得准", "1 s 内的最大夹角，" + LastBits, "PhysX、Jolt、Rapier 两步之内离开稳定轴；MuJoCo Euler 和 RK4、Drake 在 0.22 s 内变为 NaN"),
        ["Spin_of_ten_thousand_rad_a_second_is_followed_at_a_thousand_rad_a_step"] = ("每秒一万弧度的自转，每步一千弧度也算得准", "1 s 内的最大夹角，" + LastBits, "每步超过 3 rad 时，Rapier、ODE、cannon-es、Bullet 和 Havok 即使没有陀螺项也转错角度"),
        ["Plate_is_where_it_should_be"] = ("薄板处在应在的朝向", "100 s 内的最大夹角，" + LastBits, Not),
        ["Tumbling_top_keeps_its_energy"] = ("翻滚的陀螺保持能量", "100 s 后能量的变化", "MuJoCo Euler、Drake、PyBullet：× 4.8；PhysX、Jolt：+ 10 %；Bullet：− 48 %"),
        ["Tumbling_top_keeps_its_momentum_vector"] = ("翻滚的陀螺保持角动量矢量", "100 s 后 L 的相对变化", "没有引擎能保持到舍入误差；PhysX、Jolt 0.02；Bullet 0.2"),
        ["Tumbling_top_keeps_its_energy_for_a_million_steps"] = ("翻滚的陀螺一百万步保持能量", "1e6 步后能量的变化", Not),
        ["Needle_keeps_its_momentum_vector_for_a_million_steps"] = ("细针一百万步保持角动量矢量", "1e6 步后 L 的相对变化", "MuJoCo Euler 在 0.7 s 后变为 NaN；Bullet explicit × 186"),
        ["Slab_turns_over_nine_times_in_a_minute_at_the_right_moments"] = ("平板一分钟翻面九次，时刻正确", "九次翻面时刻的最大偏差，s", "应翻 9 次：PhysX、Jolt 11 次，Bullet f32 11 次，Rapier f32 12 次，Rapier f64 8 次，ODE 2 次"),
        ["Slab_off_its_axis_by_1e_8_turns_over_at_the_right_moments"] = ("偏离转轴 1e-8 的平板在正确的时刻翻面", "60 s 内翻面时刻的最大偏差，s", "没有单精度引擎翻面次数正确"),
        ["Slab_off_its_axis_by_1e_15_turns_over_at_the_right_moments"] = ("偏离转轴 1e-15 的平板在正确的时刻翻面", "60 s 内翻面时刻的最大偏差，s", Not),
        ["Slab_off_its_axis_by_1e_300_turns_over_at_the_right_moment"] = ("偏离转轴 1e-300 的平板在正确的时刻翻面", "第一次翻面（240 s 后）时刻的偏差，s", Not),
        ["Body_beside_a_stable_axis_stays_there"] = ("稳定轴附近的刚体一直留在附近", "摆动超出的部分，以 ε 或末位为单位，ε 从 1e-3 到 1e-300", "PhysX、Jolt、Rapier 在高速自转时离开稳定轴"),
        ["Body_on_an_axis_stays_on_it"] = ("恰好绕主轴转动的刚体不离开主轴", "绕每个轴转 700 rad 后的夹角，rad", "每步超过 45° 时 Bullet 和 Havok 转错角度"),
        ["Separatrix_is_followed"] = ("沿分界线的运动算得准", "20 s 内的最大夹角，" + LastBits, Not),
        ["Unit_of_the_moments_does_not_matter"] = ("结果与转动惯量的单位无关", "转动惯量取 1 与取 1e-300 至 1e300，100 s 后的夹角，rad", "单精度小于 1e-38 时下溢"),
        ["Order_of_the_axes_does_not_matter"] = ("结果与坐标轴的次序无关", "六种次序和倾斜的张量，100 s 后的夹角，rad", Not),
        ["Almost_equal_moments_are_almost_those_of_equal_ones"] = ("主转动惯量几乎相等时，运动与相等时几乎相同", "相差 1e-9 至 1e-15 时，超出差别本身所致的夹角，rad", Not),
        ["Stiff_damping_is_the_exponential"] = ("很强的阻尼也是指数衰减", "v 和 x 的相对误差；c Δt 从 1 到 1000", "PhysX、Jolt：v × max(0, 1 − c Δt)；显式方法在 c Δt 超过 2 时发散"),
        ["Spring_just_below_its_longest_step_swings_on"] = ("步长略小于弹簧的最大步长时，摆动不发散", "一百万步内的最大摆幅，初值为 1", Not),
        ["Sleeping_top_stays_upright"] = ("直立的快陀螺保持直立", "初始倾角为 1e-6 rad 的 1 倍，60 s 内最大倾角的倍数", Not),
        ["Top_that_is_too_slow_falls"] = ("转得太慢的陀螺会倒下", "60 s 内最大倾角与闭式解之差，rad", Not),
        ["Heavy_top_keeps_its_energy"] = ("重陀螺保持能量", "60 s 内的最大变化，以 m g l 为单位", Not),
        ["Masses_of_ten_to_the_twelve_to_one_turn_together"] = ("质量相差十的十二次方倍的两部分一起转动", "100 s 后的夹角，rad", Not),
        ["Body_a_million_kilometres_away_moves_by_the_same_bits"] = ("一百万千米之外的刚体运动逐位相同", "500 步后的距离，以 1e9 m 的末位为单位", "单精度在那里的间隔是 64 m：下落 490 m 根本不会开始"),
    };
}
