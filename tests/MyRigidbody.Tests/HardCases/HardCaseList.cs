namespace RigidBodyDynamics.Tests;

/// <summary>The hard cases. Results of other programs were measured with the versions named, with steps of 1/50 s unless stated.</summary>
internal static class HardCaseList
{
    private static readonly Vector3d Top = new(1, 2, 3), Spin = new(1, 1.1, 0.9);

    public static IReadOnlyList<HardCase> All { get; } =
    [
        new("Needle_one_to_a_million_is_where_it_should_be", "largest angle in 10 s, in last bits of the inputs", "every engine with a fixed step is 0.1 rad off within 0.5 s", 5, r => FreeBodies.Floors(r, "needle", "1/50")) { Weak = "RungeKutta4", WeakFrom = 1e10 },
        new("Needle_keeps_its_nutation", "change of ω² across the axis in 60 s", "Bullet, MuJoCo implicit and RK4: nutation gone; PhysX, Jolt, Rapier: energy down to 0.034", 1e-11, FreeBodies.NutationLost) { Weak = "ImplicitGyroscopic", WeakFrom = 0.99 },
        new("Spin_of_ten_thousand_rad_a_second_is_followed_at_ten_rad_a_step", "largest angle in 1 s, in last bits of the inputs", "PhysX, Jolt, Rapier leave the stable axis within two steps; MuJoCo Euler and RK4, Drake NaN within 0.22 s", 6, r => FreeBodies.Floors(r, "fast_spin", "1/1000")) { Weak = "RungeKutta4", WeakFrom = 1e9 },
        new("Spin_of_ten_thousand_rad_a_second_is_followed_at_a_thousand_rad_a_step", "largest angle in 1 s, in last bits of the inputs", "past 3 rad a step Rapier, ODE, cannon-es, Bullet and Havok turn by a wrong angle even without a gyroscopic term", 6, r => FreeBodies.Floors(r, "fast_spin", "1/10")) { Weak = "Splitting", WeakFrom = 1e9 },
        new("Plate_is_where_it_should_be", "largest angle in 100 s, in last bits of the inputs", string.Empty, 5, r => FreeBodies.Floors(r, "plate", "1/50")) { Weak = "Splitting", WeakFrom = 1e9 },
        new("Tumbling_top_keeps_its_energy", "change of energy after 100 s", "MuJoCo Euler, Drake, PyBullet: × 4.8; PhysX, Jolt: + 10 %; Bullet: − 48 %", 1e-14, r => FreeBodies.EnergyDrift(r, Top, Spin, 5000)) { Weak = "ImplicitGyroscopic", WeakFrom = 0.2 },
        new("Tumbling_top_keeps_its_momentum_vector", "change of L after 100 s, relative", "no engine to rounding; PhysX, Jolt 0.02; Bullet 0.2", 1e-13, r => FreeBodies.MomentumDrift(r, Top, Spin, 5000)) { Strong = ["Exact", "Exact4", "Exact6", "Splitting"], Weak = "ExplicitGyroscopic", WeakFrom = 1e-3 },
        new("Tumbling_top_keeps_its_energy_for_a_million_steps", "change of energy after 1e6 steps", string.Empty, 1e-14, r => FreeBodies.EnergyDrift(r, Top, Spin, 1_000_000)) { Strong = ["Exact"], Weak = "RungeKutta4", WeakFrom = 1e-7 },
        new("Needle_keeps_its_momentum_vector_for_a_million_steps", "change of L after 1e6 steps, relative", "MuJoCo Euler NaN after 0.7 s; Bullet explicit × 186", 1e-10, r => FreeBodies.MomentumDrift(r, new Vector3d(1e-6, 1, 1), new Vector3d(1000, 0.5, 0.3), 1_000_000)) { Strong = ["Exact"], Weak = "ExplicitGyroscopic", WeakFrom = 1e-2 },
        new("Slab_turns_over_nine_times_in_a_minute_at_the_right_moments", "largest deviation of nine flips, s", "PhysX, Jolt 11, Bullet f32 11, Rapier f32 12, Rapier f64 8, ODE 2 flips instead of 9", 1e-3, r => Flips.Off(r, 1e-3, 5, 0.02, 60)) { Weak = "ExplicitGyroscopic", WeakFrom = double.PositiveInfinity },
        new("Slab_off_its_axis_by_1e_8_turns_over_at_the_right_moments", "largest deviation of the flips in 60 s, s", "no float engine counts right", 1e-3, r => Flips.Off(r, 1e-8, 5, 0.02, 60)) { Weak = "RungeKutta4", WeakFrom = 0.05 },
        new("Slab_off_its_axis_by_1e_15_turns_over_at_the_right_moments", "largest deviation of the flips in 60 s, s", string.Empty, 1e-3, r => Flips.Off(r, 1e-15, 5, 0.02, 60)) { Weak = "Splitting", WeakFrom = 0.05 },
        new("Slab_off_its_axis_by_1e_300_turns_over_at_the_right_moment", "deviation of the first flip, after 240 s, s", string.Empty, 1e-3, r => Flips.Off(r, 1e-300, 5, 0.02, 300)) { Weak = "ImplicitGyroscopic", WeakFrom = 0.05 },
        new("Body_beside_a_stable_axis_stays_there", "excess of the swing, in ε or last bits, ε from 1e-3 to 1e-300", "PhysX, Jolt, Rapier leave a stable axis at high spin", 10, FreeBodies.SwingBesideStableAxis) { Weak = "ExplicitGyroscopic", WeakFrom = 10 },
        new("Body_on_an_axis_stays_on_it", "angle after 700 rad about each axis, rad", "Bullet and Havok turn by a wrong angle past 45° a step", 1e-12, FreeBodies.OffItsAxis) { Weak = "Splitting", WeakFrom = 1e-2 },
        new("Separatrix_is_followed", "largest angle in 20 s, in last bits of the inputs", string.Empty, 5, r => FreeBodies.Floors(r, "separatrix", "1/50")) { Weak = "RungeKutta4", WeakFrom = 1e3 },
        new("Unit_of_the_moments_does_not_matter", "angle between moments 1 and 1e-300 to 1e300 after 100 s, rad", "single precision underflows below 1e-38", 1e-11, Descriptions.InAnotherUnit) { Weak = "UnityRigidbody", WeakFrom = 1e-3 },
        new("Order_of_the_axes_does_not_matter", "angle between six orders and a tilted tensor after 100 s, rad", string.Empty, 1e-11, Descriptions.InAnotherOrder) { Weak = "Splitting", WeakFrom = 1e-4 },
        new("Almost_equal_moments_are_almost_those_of_equal_ones", "angle beyond what the difference does, 1e-9 to 1e-15, rad", string.Empty, 1e-11, Descriptions.AlmostEqual) { Weak = "RungeKutta4", WeakFrom = 1e-11 },
        new("Stiff_damping_is_the_exponential", "v and x, relative; c Δt from 1 to 1000", "PhysX, Jolt: v × max(0, 1 − c Δt); explicit integrators diverge past c Δt = 2", 1e-12, DrivenBodies.StiffDamping) { Weak = "RungeKutta4", WeakFrom = 1e3 },
        new("Spring_just_below_its_longest_step_swings_on", "largest swing in a million steps, of 1", string.Empty, 1.001, r => DrivenBodies.Swing(r, 0.999)) { Strong = ["Exact", "Splitting"], Weak = "ExplicitEuler", WeakFrom = 1e6 },
        new("Sleeping_top_stays_upright", "largest tilt in 60 s, in 1e-6 rad, from one of 1", string.Empty, 2, DrivenBodies.SleepingTop) { Weak = "ExplicitGyroscopic", WeakFrom = 10 },
        new("Top_that_is_too_slow_falls", "largest tilt in 60 s against the closed form, rad", string.Empty, 1e-2, DrivenBodies.FallenTop) { Weak = "ImplicitGyroscopic", WeakFrom = 0.5 },
        new("Heavy_top_keeps_its_energy", "largest change in 60 s, of m g l", string.Empty, 2e-3, DrivenBodies.HeavyTopEnergy) { Strong = ["Exact", "Exact4", "Exact6", "Splitting"], Weak = "ImplicitGyroscopic", WeakFrom = 0.01 },
        new("Masses_of_ten_to_the_twelve_to_one_turn_together", "angle after 100 s, rad", string.Empty, 1e-11, DrivenBodies.HugeMassRatio) { Weak = "ExplicitGyroscopic", WeakFrom = 1e-6 },
        new("Body_a_million_kilometres_away_moves_by_the_same_bits", "distance in last bits of 1e9 m after 500 steps", "single precision knows 64 m there: a fall of 490 m does not begin", 5000, DrivenBodies.FarAway) { Weak = "UnityRigidbody", WeakFrom = 1e9 },
    ];

    public static HardCase Named(string name) => All.Single(hard => hard.Name == name);
}
