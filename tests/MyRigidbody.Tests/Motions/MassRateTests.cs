using NUnit.Framework;
using RigidBodyDynamics.Tests.SceneFiles;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies that lose or gain mass, against the rocket's equation and integrals of it.</summary>
public sealed class MassRateTests
{
    private const double Kilograms = 5, Rate = -2, Time = 2, Newton = 30;
    private static readonly Vector3d Moments = new(1, 2, 2.5), Z = new(0, 0, 1), Centre = new(0.1, -0.2, 0.3);

    private static IEnumerable<string> Rule => Scenery.Integrators;

    private static IEnumerable<string> Compositions => ["Splitting", "Exact", "Exact4", "Exact6"];

    [TestCase("Splitting", 1)]
    [TestCase("Splitting", 100)]
    [TestCase("Exact", 1)]
    [TestCase("Exact", 100)]
    public void Rocket_comes_to_its_exhaust_s_speed_times_the_logarithm_of_the_masses(string rule, int steps)
    {
        // u |m'| = F; and one that does not turn feels a thrust along its axis as a force along the world's
        double v = -Newton / Rate * Math.Log(Kilograms / (Kilograms + Rate * Time));
        foreach (bool inBody in new[] { false, true })
        {
            BodyState end = Run(Body(rule, Vector3d.Zero).With(new Force(Newton * Z, inBody: inBody)), steps);
            Assert.That(end.Velocity.Z, Is.EqualTo(v).Within(1e-13)); // measured 1.1e-14
        }
    }

    [TestCaseSource(nameof(Rule))]
    public void Integrator_keeps_its_order_under_a_thruster_beside_the_centre_of_a_mass_that_burns(string rule)
    {
        Rule by = Scenery.Body(rule).Rule;
        if (by == Rules.UnityRigidbody && rule == by.Name)
            Assert.That(Off(200), Is.LessThan(0.02)); // single precision ends before its order shows
        else
            Assert.That(Math.Log2(Off(by.Order > 4 ? 16 : 32) / Off(by.Order > 4 ? 32 : 64)), Is.EqualTo(by.Order).Within(0.25), $"{Off(32)} {Off(64)}");

        double Off(int steps)
        {
            BodyState end = Run(Body(rule, 1.5 * Z).With(new Force(new Vector3d(3, 0, 0), at: Centre + new Vector3d(0, -0.5, 0), inBody: true)), steps), exact = Driven();
            return Apart(end.Velocity, exact.Velocity) + Conserved.AngleBetween(end.Orientation, exact.Orientation);
        }
    }

    // those of a higher order let time stand still while they push, and are of that order here
    [TestCase("Splitting", 1e-13)] // measured 1.2e-15
    [TestCase("Exact", 1e-13)] // measured 1.2e-15
    [TestCase("Exact4", 1e-7)] // measured 1.7e-8
    [TestCase("Exact6", 1e-10)] // measured 1.1e-11
    public void What_keeps_momentum_goes_faster_as_it_gets_lighter(string rule, double bound)
    {
        Body body = Started(Bare(rule, 1.5 * Z, new Vector3d(1, 2, 3)).With(new MassRate(Rate, Keeping.Momentum)), 50);
        body.Simulation.Step(50);
        double left = 1 + Rate * Time / Kilograms, angle = 1.5 * Kilograms / Rate * Math.Log(left);
        Assert.That(Apart(left * body.State.Velocity, new Vector3d(1, 2, 3)), Is.LessThan(bound));
        Assert.That(Apart(left * body.State.AngularVelocity, 1.5 * Z), Is.LessThan(bound));
        Assert.That(Conserved.AngleBetween(body.State.Orientation, Quaterniond.FromAxisAngle(Z, angle)), Is.LessThan(2e-2)); // of order 2; Splitting, whose turns are rational, 1.4e-2
        Assert.That(Apart(body.AngularMomentum, Moments.Z * 1.5 * Z), Is.LessThan(3 * bound));
        Assert.That(body.Mass.Mass, Is.EqualTo(Kilograms * left).Within(1e-14));
    }

    [TestCaseSource(nameof(Rule))]
    public void Free_body_that_keeps_velocity_moves_by_the_bits_of_one_that_burns_nothing(string rule)
    {
        BodyDescription calm = Scenery.Body(rule).With(new Gravity(new Vector3d(0, -9.81, 0))).With(new AngularDamping(0.1));
        BodyDescription burns = Scenery.Body(rule).With(new Gravity(new Vector3d(0, -9.81, 0))).With(new AngularDamping(0.1)).With(new MassRate(-0.5));
        TimeSteps steps = TimeSteps.Every(0.02, 100);
        Assert.That(Scenery.Run(steps, burns, 100), Is.EqualTo(Scenery.Run(steps, calm, 100)));
    }

    [TestCaseSource(nameof(Compositions))]
    public void Push_sees_the_mass_of_its_time(string rule)
    {
        // a field that pulls by the mass gives the same fall whatever the mass
        BodyState end = Run(Body(rule, Vector3d.Zero).With(new Field(new Vector3d(0, -9.81, 0))), 100);
        Assert.That(end.Velocity.Y, Is.EqualTo(-9.81 * Time).Within(1e-13)); // measured 7.1e-15
    }

    [TestCase("Splitting", 1e-13)] // measured 1.1e-15
    [TestCase("Exact", 1e-13)] // measured 1.1e-15
    [TestCase("Exact4", 1e-10)] // measured 1.8e-11
    [TestCase("Exact6", 1e-13)]
    public void Wheel_in_a_hinge_gets_the_spin_of_a_moment_that_falls(string rule, double bound)
    {
        BodyDescription body = Body(rule, Vector3d.Zero).With(Torque.Constant(0.8 * Z));
        body.Lock = Locks.TurnX | Locks.TurnY | Locks.Move;
        double spin = 0.8 / Moments.Z * Kilograms / Rate * Math.Log(1 + Rate * Time / Kilograms);
        Assert.That(Run(body, 100).AngularVelocity.Z, Is.EqualTo(spin).Within(bound));
    }

    [Test]
    public void Program_s_pushes_act_on_the_mass_of_now_and_go_on_with_it()
    {
        Body body = Started(new BodyDescription("b", MassProperties.FromPrincipal(Kilograms, Moments)).With(new MassRate(Rate), 0, 1).With(new Force(Z), 3, 4), 100);
        body.Simulation.Step(50);
        body.ApplyImpulse(new Vector3d(6, 0, 0));
        Assert.That(body.State.Velocity.X, Is.EqualTo(2).Within(1e-15)); // 5 kg − 2 kg
        body.ApplyForce(new Vector3d(6, 0, 0), body.State.Position + new Vector3d(0, 1, 0));
        body.Simulation.Step(1);
        Assert.That(body.State.Velocity.X, Is.EqualTo(2 + 2 * Time / 100).Within(1e-15));
        Assert.That(body.State.AngularVelocity.Z, Is.EqualTo(-6 * Time / 100 / (0.6 * Moments.Z)).Within(1e-15));
        body.Simulation.StepBy(0.5);
        body.Simulation.Step(1);
        Assert.That(body.Mass.Mass, Is.EqualTo(3).Within(1e-14));
        Assert.That(body.Mass.PrincipalMoments.Y, Is.EqualTo(0.6 * 2).Within(1e-14));
        body.Change(new BodyDescription("c", MassProperties.FromPrincipal(7, Moments)));
        Assert.That(body.Mass.Mass, Is.EqualTo(7));
    }

    [Test]
    public void Force_coasts_again_once_the_burn_is_over()
    {
        Body body = new Simulation(TimeSteps.Every(0.02), Bare("Exact", Vector3d.Zero, Vector3d.Zero).With(new MassRate(Rate), 0, 1).With(new Force(Newton * Z))).Bodies[0];
        body.Simulation.Step(50);
        double v = Newton / -Rate * Math.Log(5.0 / 3);
        body.Simulation.Step(100);
        Assert.That(body.IsDormant, Is.True);
        Assert.That(body.State.Velocity.Z, Is.EqualTo(v + 2 * Newton / 3).Within(1e-13)); // measured 3.6e-15
    }

    [TestCaseSource(nameof(Rule))]
    public void Many_bodies_burn_to_the_bits_of_one_each_from_when_it_came(string rule)
    {
        BodyDescription body = Scenery.Body(rule).With(new MassRate(-0.5), 0, 1.5).With(new Force(new Vector3d(1, 2, 0))).With(new Impulse(Z), 0.5).With(new LinearDamping(0.1));
        Simulation together = new(TimeSteps.Every(1.0 / 64));
        Body first = together.Add(body), second = together.Add(body, Pushes.State with { Velocity = Z });
        together.Step(10);
        Body third = together.Add(body);
        together.Step(90);
        Assert.That(first.State, Is.EqualTo(Alone(0, Pushes.State)));
        Assert.That(second.State, Is.EqualTo(Alone(0, Pushes.State with { Velocity = Z })));
        Assert.That(third.State, Is.EqualTo(Alone(10, Pushes.State)));
        Assert.That(third.Mass.Mass - first.Mass.Mass, Is.EqualTo(0.5 * 10 / 64).Within(1e-14));

        BodyState Alone(int step, BodyState start)
        {
            Simulation alone = new(TimeSteps.Every(1.0 / 64));
            alone.Step(step);
            Body one = alone.Add(body, start);
            alone.Step(100 - step);
            return one.State;
        }
    }

    [Test]
    public void Mass_that_is_gone_before_the_end_is_refused_with_the_time()
    {
        Assert.That(() => Started(Bare("Exact", Vector3d.Zero, Vector3d.Zero).With(new MassRate(-4)), 10), Throws.InstanceOf<ArgumentException>().With.Message.EqualTo(
            "effects[0]: must leave mass to the end; all is gone at t = 1.25 s, found -4"));
        Assert.That(() => new Simulation(TimeSteps.Every(0.1), Bare("Exact", Vector3d.Zero, Vector3d.Zero).With(new MassRate(-1))), Throws.InstanceOf<ArgumentException>().With.Message.Contains("t = 5 s"));
        string scene = """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "duration": 3, "bodies": [ { "name": "b", "mass": 5, "effects": [
              { "gravity": [0, 0, 0] }, { "massRate": { "rate": -2, "keeps": "momentum" } } ] } ] }
            """;
        Assert.That(SceneText.Error(scene), Is.EqualTo("scene.json: bodies[0].effects[1]: must leave mass to the end; all is gone at t = 2.5 s, found -2"));
        Assert.That(SceneText.Read(scene.Replace("3,", "2,")).Scene.Bodies[0].Effects[1].Motion, Is.EqualTo(new MassRate(-2, Keeping.Momentum)));
    }

    [Test]
    public void Plan_says_what_burns() => Assert.That(
        new Explanation(Started(Body("Exact", Vector3d.Zero), 10).Plan).ToString(), Does.Contain("mass -2 kg/s, velocity kept"));

    /// <summary>I(t) ω' = τ, so ω is a logarithm; the angle and v are its integrals, by Gauss's rule of two points in 4000 panels.</summary>
    private static BodyState Driven()
    {
        const int panels = 4000;
        double h = Time / panels, alpha = 0.5 * 3 / Moments.Z, k = Rate / Kilograms;
        Vector3d v = Vector3d.Zero;
        for (int i = 0; i < 2 * panels; i++)
        {
            double t = h * (i / 2 + 0.5 + (i % 2 - 0.5) / Math.Sqrt(3));
            v += 0.5 * h * 3 / (Kilograms * (1 + k * t)) * new Vector3d(Math.Cos(Angle(t)), Math.Sin(Angle(t)), 0);
        }

        return new BodyState(Vector3d.Zero, Quaterniond.FromAxisAngle(Z, Angle(Time)), v, Vector3d.Zero);

        // ∫ ln(1 + k t) dt = ((1 + k t) ln(1 + k t) − k t) / k
        double Angle(double t) => 1.5 * t + alpha / k * ((1 + k * t) * Math.Log(1 + k * t) - k * t) / k;
    }

    private static BodyDescription Bare(string rule, Vector3d spin, Vector3d velocity)
    {
        BodyDescription like = Scenery.Body(rule);
        return new BodyDescription("body", MassProperties.FromPrincipal(Kilograms, Moments, Quaterniond.Identity, Centre))
        {
            Rule = like.Rule,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, velocity, spin),
            Unity = new UnitySettings { InDouble = like.Unity.InDouble, AngularDrag = 0 },
        };
    }

    private static BodyDescription Body(string rule, Vector3d spin) => Bare(rule, spin, Vector3d.Zero).With(new MassRate(Rate));

    private static Body Started(BodyDescription body, int steps) => new Simulation(TimeSteps.Every(Time / steps, body.Effects.Any(effect => effect.To < 9) ? long.MaxValue : steps), body).Bodies[0];

    private static BodyState Run(BodyDescription body, int steps) => Scenery.Run(TimeSteps.Every(Time / steps, steps), body, steps);

    private readonly struct Field(Vector3d g) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => wrench.Force += mass.Mass * g;

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => impulse.Force += duration * mass.Mass * g;
    }
}
