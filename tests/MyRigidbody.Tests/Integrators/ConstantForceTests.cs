using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A constant force has a closed form, as gravity has.</summary>
public sealed class ConstantForceTests
{
    private const double Mass = 1, Damping = 30;
    private static readonly Vector3d F = new(800, -30, 0.5), V = new(1, 2, -3);
    private static readonly TimeSteps Steps = TimeSteps.Every(1.0 / 30);

    // half a push before and half after gave a terminal velocity with an error of 8.2 %
    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    [TestCase("Splitting")]
    public void Damped_body_under_a_force_moves_as_its_equation_says(string rule)
    {
        Simulation coasting = new(Steps, Body(rule).With(new Force(F)));
        Simulation stepped = Scenery.Stepped(Steps, Body(rule).With(new Force(F)));
        double worst = 0;
        for (int n = 1; n <= 300; n++)
        {
            coasting.Step();
            stepped.Step();
            BodyState expected = Solved(BodyAt(Vector3d.Zero, V), F, n / 30.0);
            foreach (BodyState found in new[] { coasting.Bodies[0].State, stepped.Bodies[0].State })
                worst = Math.Max(worst, Math.Max(Apart(found.Velocity, expected.Velocity), Apart(found.Position, expected.Position)));
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2}"));
        Assert.That(worst, Is.LessThan(2e-15)); // measured 3.2e-16
    }

    [Test]
    public void Force_in_a_window_is_exact_and_the_body_lies_before_in_and_after_it()
    {
        Simulation simulation = new(Steps, Body("Exact").With(new Force(F), 1, 2));
        Body body = simulation.Bodies[0];
        for (int n = 0; n < 100; n++)
        {
            Assert.That(body.IsDormant, $"step {n}");
            simulation.Step();
        }

        BodyState one = Solved(BodyAt(Vector3d.Zero, V), Vector3d.Zero, 1), two = Solved(one, F, 1), end = Solved(two, Vector3d.Zero, 100 / 30.0 - 2);
        double apart = Math.Max(Apart(body.State.Position, end.Position), (body.State.Velocity - end.Velocity).Length);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{apart:g2}"));
        Assert.That(apart, Is.LessThan(2e-15)); // measured 2.7e-16
    }

    [Test]
    public void Free_motion_knows_the_force_and_refuses_one_that_ends()
    {
        FreeMotion motion = new(Body("Exact").With(new Force(F)));
        BodyState expected = Solved(BodyAt(Vector3d.Zero, V), F, 0.7), found = motion.At(0.7);
        Assert.That(Math.Max(Apart(found.Position, expected.Position), Apart(found.Velocity, expected.Velocity)), Is.LessThan(2e-15)); // measured 2.7e-16
        Assert.That(() => new FreeMotion(Body("Exact").With(new Force(F), 0, 1)), Throws.InstanceOf<ArgumentException>().With.Message.Contains("effects[1]"));
    }

    // to rounding: F/m is summed with g before the step, and not in it
    [TestCase("LabEuler")]
    [TestCase("ExplicitEuler")]
    [TestCase("RungeKutta4")]
    [TestCase("ImplicitGyroscopic")]
    [TestCase("ExplicitGyroscopic")]
    [TestCase("UnityRigidbody in double")]
    public void Other_integrators_move_as_under_a_push_of_the_same_force(string rule)
    {
        BodyDescription body = Scenery.Body(rule).With(new Gravity(new Vector3d(0.3, -9.81, 1))).With(new LinearDamping(0.2));
        BodyState coasting = Scenery.Run(Steps, body.Copy("coasting", body.Mass).With(new Force(F)), 60);
        BodyState pushed = Scenery.Run(Steps, body.Copy("pushed", body.Mass).With(new Pushed(new Force(F))), 60);
        double apart = Math.Max(Apart(coasting.Position, pushed.Position), Apart(coasting.Velocity, pushed.Velocity));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{apart:g2}"));
        Assert.That(apart, Is.LessThan(1e-15)); // measured 1.1e-17
        Assert.That(coasting.Orientation, Is.EqualTo(pushed.Orientation));
    }

    [Test]
    public void Explain_names_it_once_and_does_not_leave_it_out()
    {
        string exact = Said("Exact"), unity = Said("UnityRigidbody");
        Assert.That(exact, Does.Contain("force (800, -30, 0.5) N (closed form)").And.Contain("computed when its state is read"));
        Assert.That(unity, Does.Contain("force (800, -30, 0.5) N").And.Not.Contain("somebody looks"));
        foreach (string said in new[] { exact, unity })
        {
            Assert.That(said.Split("force (800"), Has.Length.EqualTo(2), said);
            Assert.That(said, Does.Not.Contain("forces and torques"));
        }

        static string Said(string rule) => new Explanation(new Simulation(Steps, Body(rule).With(new Force(F))).Bodies[0]).ToString();
    }

    [Test]
    public void Force_keeps_a_body_of_Unity_awake_and_gravity_does_not()
    {
        BodyDescription lies = new("lies", Solids.Sphere(1, 1)) { Rule = Rules.UnityRigidbody };
        Simulation pushed = new(Steps, lies.Copy("pushed", lies.Mass).With(new Force(new Vector3d(1e-9, 0, 0)))), let = new(Steps, lies);
        pushed.Step(100);
        let.Step(100);
        Assert.That((pushed.Bodies[0].IsAsleep, let.Bodies[0].IsAsleep), Is.EqualTo((false, true)));
    }

    /// <summary>v' = F/m − c v for a time.</summary>
    private static BodyState Solved(BodyState from, Vector3d force, double time)
    {
        double left = Math.Exp(-Damping * time);
        Vector3d last = 1 / (Mass * Damping) * force, over = from.Velocity - last;
        return BodyAt(from.Position + time * last + ((1 - left) / Damping) * over, last + left * over);
    }

    private static BodyDescription Body(string rule) =>
        new BodyDescription("body", MassProperties.FromPrincipal(Mass, new Vector3d(1, 2, 2.5))) { Rule = Rules.Named(rule), Start = BodyAt(Vector3d.Zero, V) }
            .With(new LinearDamping(Damping));

    private static BodyState BodyAt(Vector3d position, Vector3d velocity) => new(position, Quaterniond.Identity, velocity, new Vector3d(0.3, 0.4, -1));

    private static double Apart(Vector3d found, Vector3d expected) => Samples.Apart(found, expected) / expected.Length;

    /// <summary>Hides that a force is constant.</summary>
    private readonly struct Pushed(Force force) : IPush
    {
        public EffectTraits Traits => force.Traits;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => force.At(now, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            force.Over(now, duration, body, mass, ref impulse);
    }
}
