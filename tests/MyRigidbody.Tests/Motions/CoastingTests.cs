using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Gravity and damping: one closed form for all of them.</summary>
public sealed class CoastingTests
{
    private static readonly Vector3d Down = new(0.5, -9.81, 2);

    [Test]
    public void Effects_add_their_shares()
    {
        Coasting coasting = Coasting.Free;
        ICoast[] effects =
        [
            new Gravity(new Vector3d(1, 2, 3)), new Gravity(new Vector3d(10, 20, 30)),
            new LinearDamping(0.25), new LinearDamping(0.5), new AngularDamping(2), new AngularDamping(4),
            new DecayPerStep(0.5, 0.25), new DecayPerStep(0.5, 0.5), new Force(new Vector3d(200, 400, 600)),
        ];
        foreach (ICoast effect in effects)
            effect.AddTo(ref coasting, Solids.Sphere(2, 1));
        Assert.That(coasting, Is.EqualTo(new Coasting
        {
            Acceleration = new Vector3d(111, 222, 333),
            LinearDampingRate = 0.75,
            AngularDampingRate = 6,
            LinearFactorPerStep = 0.25,
            AngularFactorPerStep = 0.125,
        }));
    }

    [Test]
    public void Free_body_drifts_on_and_loses_nothing()
    {
        BodyState state = Pushes.State;
        Coasting.Free.Advance(0.5, ref state);
        BodyState expected = Pushes.State;
        expected.Position += 0.5 * expected.Velocity;
        Assert.That(state, Is.EqualTo(expected));
        Assert.That((Coasting.Free.LinearDecay(0.5), Coasting.Free.AngularDecay(0.5)), Is.EqualTo((1.0, 1.0)));
    }

    [Test]
    public void Damping_leaves_a_part_exp_of_minus_c_h_and_the_factor_per_step_comes_once()
    {
        Coasting coasting = Coasting.Free;
        new LinearDamping(0.3).AddTo(ref coasting, Solids.Sphere(2, 1));
        new AngularDamping(2).AddTo(ref coasting, Solids.Sphere(2, 1));
        Assert.That(coasting.LinearDecay(0.5), Is.EqualTo(Math.Exp(-0.15)).Within(2e-16)); // measured 0
        Assert.That(coasting.AngularDecay(0.5), Is.EqualTo(Math.Exp(-1)).Within(1e-16)); // measured 0
        new DecayPerStep(0.98, 0.5).AddTo(ref coasting, Solids.Sphere(2, 1));
        Assert.That(coasting.LinearDecay(0.5), Is.EqualTo(0.98 * Math.Exp(-0.15)).Within(2e-16)); // measured 0
        Assert.That(coasting.AngularDecay(0.5), Is.EqualTo(0.5 * Math.Exp(-1)).Within(1e-16)); // measured 0
    }

    [Test]
    public void Lab_factor_leaves_what_its_documentation_says_after_a_second()
    {
        foreach ((int steps, double left) in new[] { (50, 0.36), (60, 0.30), (144, 0.05) })
        {
            BodyState start = BodyState.AtRest;
            start.Velocity = new Vector3d(1, 0, 0);
            start.AngularVelocity = new Vector3d(0, 1, 0);
            Simulation simulation = new(
                TimeSteps.Every(1.0 / steps), new BodyDescription("b", Pushes.Mass) { Start = start }.With(new DecayPerStep(0.98, 0.98)));
            simulation.Step(steps);
            // given in whole per cent
            Assert.That(simulation.Bodies[0].State.Velocity.X, Is.EqualTo(left).Within(0.005)); // measured 0.0045
            Assert.That(simulation.Bodies[0].State.AngularVelocity.Y, Is.EqualTo(left).Within(0.005)); // measured 0.0047
        }
    }

    // c = 0, c h from a millionth of a millionth to a thousand
    [TestCase(0, 0.25)]
    [TestCase(0, 10)]
    [TestCase(1e-300, 1)]
    [TestCase(1e-12, 1)]
    [TestCase(1e-5, 0.25)]
    [TestCase(0.3, 0.25)]
    [TestCase(0.3, 10)]
    [TestCase(16, 0.0625)]
    [TestCase(500, 2)]
    [TestCase(1000, 1)]
    public void Flow_of_gravity_and_damping_is_the_closed_form(double c, double h)
    {
        Coasting coasting = new() { Acceleration = Down, LinearDampingRate = c, AngularDampingRate = 2 * c };
        BodyState state = Pushes.State;
        coasting.Advance(h, ref state);

        // with s = (1 − e^(−ch))/c: v = e^(−ch) v₀ + s g, x = x₀ + s v₀ + (h − s)/c g, to 256 bits where that cancels
        double s = h * ManyDigits.Phi1(c * h).ToDouble(), r = h * h * ManyDigits.Phi2(c * h).ToDouble(), left = Math.Exp(-c * h);
        BodyState start = Pushes.State;
        Vector3d v = left * start.Velocity + s * Down;
        Vector3d x = start.Position + s * start.Velocity + r * Down;
        Assert.That(Apart(state.Velocity, v) / v.Length, Is.LessThan(1e-15)); // measured 1.7e-16
        Assert.That(Apart(state.Position, x) / x.Length, Is.LessThan(1e-15)); // measured 1.2e-16
        double spin = Apart(state.AngularVelocity, Math.Exp(-2 * c * h) * start.AngularVelocity) / start.AngularVelocity.Length;
        Assert.That(spin, Is.LessThan(1e-15)); // measured 8.3e-17
        Assert.That(state.Orientation, Is.EqualTo(start.Orientation));
    }

    [Test]
    public void Strongly_damped_body_falls_at_g_over_c()
    {
        Coasting coasting = new() { Acceleration = Down, LinearDampingRate = 1e6 };
        BodyState state = Pushes.State;
        coasting.Advance(1, ref state);
        Assert.That(Apart(state.Velocity, Down / 1e6), Is.LessThan(5e-21)); // measured 1.7e-21, one unit in the last place
    }

    [Test]
    public void Two_half_steps_are_the_whole_step() => Property.Holds(
        Gen.Select(
            Vectors,
            Vectors,
            Gen.OneOf<double>(Gen.Double[-6, 2].Select(digits => Math.Pow(10, digits)), Gen.OneOf(0.0)),
            Gen.Double[0.001, 10]),
        t =>
        {
            (Vector3d v, Vector3d g, double c, double h) = t;
            Coasting coasting = new() { Acceleration = g, LinearDampingRate = c, AngularDampingRate = c / 2 };
            BodyState whole = new(Vector3d.Zero, Quaterniond.Identity, v, v), halves = whole;
            coasting.Advance(h, ref whole);
            coasting.Advance(h / 2, ref halves);
            coasting.Advance(h / 2, ref halves);
            return new[]
            {
                Apart(halves.Position, whole.Position) / (h * v.Length + h * h * g.Length),
                Apart(halves.Velocity, whole.Velocity) / (v.Length + h * g.Length),
                Apart(halves.AngularVelocity, whole.AngularVelocity) / v.Length,
            }.Max();
        },
        4e-15); // measured 3.8e-16

    [Test]
    public void Flow_starts_off_with_m_times_g_minus_c_v_and_with_minus_c_L()
    {
        const double h = 1e-6;
        Coasting coasting = new() { Acceleration = Down, LinearDampingRate = 0.5, AngularDampingRate = 3 };
        BodyState later = Pushes.State;
        coasting.Advance(h, ref later);
        Vector3d acceleration = (later.Velocity - Pushes.State.Velocity) / h;
        Assert.That(Apart(acceleration, Down - 0.5 * Pushes.State.Velocity), Is.LessThan(1e-4)); // measured 5.8e-6, of order h
        Vector3d turning = (Conserved.AngularMomentum(later, Pushes.Mass) - Conserved.AngularMomentum(Pushes.State, Pushes.Mass)) / h;
        Assert.That(Apart(turning, -3 * Conserved.AngularMomentum(Pushes.State, Pushes.Mass)), Is.LessThan(1e-4)); // measured 1.3e-5, of order h
    }

    [Test]
    public void Fall_with_linear_drag_is_the_reference_to_a_few_roundings()
    {
        ExactCase exact = ExactCase.Read("fall_linear_drag");
        Coasting coasting = Coasting.Free;
        new Gravity(new Vector3d(0, -9.81, 0)).AddTo(ref coasting, Solids.Sphere(2, 1));
        new LinearDamping(0.3).AddTo(ref coasting, Solids.Sphere(2, 1));
        double worst = 0, speed = 0;
        foreach (ExactCase.Sample sample in exact.Samples)
        {
            BodyState state = BodyState.AtRest;
            coasting.Advance(sample.Time, ref state);
            worst = Math.Max(worst, Apart(state.Position, sample.Position) / Floor(sample));
            speed = Math.Max(speed, Apart(state.Velocity, sample.Velocity) / (sample.Velocity.Length + 1e-300));
        }

        Assert.That(worst, Is.LessThan(5)); // measured 1.9
        Assert.That(speed, Is.LessThan(6e-16)); // measured 2.8e-16
    }

    [Test]
    public void Push_for_a_second_and_drag_after_it_is_the_reference_to_a_few_roundings()
    {
        ExactCase exact = ExactCase.Read("force_then_coast");
        Coasting pushed = new() { Acceleration = new Vector3d(5, 0, 0), LinearDampingRate = 1 }, coasting = new() { LinearDampingRate = 1 };
        double worst = 0, speed = 0;
        foreach (ExactCase.Sample sample in exact.Samples)
        {
            BodyState state = BodyState.AtRest;
            pushed.Advance(Math.Min(1, sample.Time), ref state);
            coasting.Advance(Math.Max(0, sample.Time - 1), ref state);
            worst = Math.Max(worst, Apart(state.Position, sample.Position) / Floor(sample));
            speed = Math.Max(speed, Apart(state.Velocity, sample.Velocity) / (sample.Velocity.Length + 1e-300));
        }

        Assert.That(worst, Is.LessThan(5)); // measured 1.6
        Assert.That(speed, Is.LessThan(6e-16)); // measured 2e-16
    }

    // what the last bit of the inputs does to the place; nothing at the start
    private static double Floor(ExactCase.Sample sample) => Math.Max(sample["double_position_error"], 1e-300);
}
