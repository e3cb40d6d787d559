using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies at rest or almost at rest, and bodies that any disturbance would move.</summary>
public sealed class QuietBodyTests
{
    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Body_at_rest_keeps_every_bit(string integrator)
    {
        foreach (Vector3d moments in new Vector3d[] { new(1, 2, 2.5), new(2, 2, 1), new(1, 1, 1), new(1e-18, 2e-18, 2.5e-18) })
        {
            BodyDescription body = new("b", MassProperties.FromPrincipal(1, moments)) { Rule = Scenery.Body(integrator).Rule };
            body.Start = new BodyState(new Vector3d(1, -2, 3), new Quaterniond(0.5, 0.5, -0.5, 0.5), Vector3d.Zero, Vector3d.Zero);
            body.Unity.InDouble = true;
            Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), body);
            simulation.Step(100_000);
            Assert.That(simulation.Bodies[0].State, Is.EqualTo(body.Start));
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Velocities_damped_to_denormals_and_beyond_come_to_rest(string integrator)
    {
        foreach (Vector3d moments in new Vector3d[] { new(1, 2, 2.5), new(2, 2, 1), new(2, 2, 2) })
        {
            BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(1, moments))
            {
                Rule = Scenery.Body(integrator).Rule,
                Unity = Scenery.Body(integrator).Unity,
                Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(0.3, 1.1, -0.7)),
            }.With(new DecayPerStep(0.98, 0.98));
            Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), body);
            // 0.98^36000 = 1e-316; what a factor cannot make smaller is the least double
            simulation.Step(36_000);
            Assert.That(simulation.Bodies[0].State.Velocity.Length, Is.LessThan(1e-300)); // measured 0
            BodyState there = simulation.Bodies[0].State;
            simulation.Step(64_000);
            BodyState state = simulation.Bodies[0].State;
            Assert.That(state.IsFinite);
            Assert.That(state.Velocity.Length, Is.LessThan(1e-300)); // measured 0
            Assert.That(state.AngularVelocity.Length, Is.LessThan(1e-300)); // measured 0
            Assert.That(Samples.Apart(state.Position, there.Position), Is.LessThan(1e-15)); // measured 0
            Assert.That(Conserved.AngleBetween(state.Orientation, there.Orientation), Is.LessThan(1e-15)); // measured 0
            Assert.That(state.Orientation.Length, Is.EqualTo(1).Within(integrator == "UnityRigidbody" ? 1e-7 : 1e-15)); // measured 2.1e-8 and 2.2e-16
        }
    }

    // v₀/(1 − 0.98) steps of 0.02 s, times 0.98 where the velocity is damped before it moves the body
    [TestCase("LabEuler", 1)]
    [TestCase("Exact", 1)]
    public void Body_damped_step_by_step_goes_as_far_as_the_geometric_series(string integrator, double times)
    {
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1, 1)) { Rule = Rules.Named(integrator) }.With(new DecayPerStep(0.98, 0.98));
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), Vector3d.Zero);
        Assert.That(
            Scenery.Run(TimeSteps.Every(0.02), body, 100_000).Position.X,
            Is.EqualTo(times * 0.02 / (1 - 0.98)).Within(4e-15)); // measured 4.4e-16
    }

    [TestCase("Exact")]
    [TestCase("Splitting")]
    public void Spring_beyond_its_longest_step_diverges(string integrator) =>
        Assert.That(DrivenBodies.Swing(integrator, 1.001), Is.EqualTo(double.PositiveInfinity));

    [Test]
    public void Longest_step_of_a_spring_on_an_arm_holds_for_small_swings()
    {
        // 2/ω, ω² = k (1/m + a²/I): the arm (0, 0.5, 0), moments 1, 2, 2.5, m = 2, k = 4
        MassProperties mass = MassProperties.FromPrincipal(2, new Vector3d(1, 2, 2.5));
        Spring spring = new(new Vector3d(0, 0.5, 0), Vector3d.Zero, 4);
        double longest = spring.LongestStableStep(mass);
        Assert.That(longest, Is.EqualTo(2 / Math.Sqrt(4 * (0.5 + 0.25))).Within(1e-15)); // measured 0
        Assert.That(new Spring(Vector3d.Zero, Vector3d.Zero, 100).LongestStableStep(mass), Is.EqualTo(2 / Math.Sqrt(50)).Within(1e-15)); // measured 0

        BodyDescription body = new BodyDescription("b", mass) { Start = new BodyState(new Vector3d(1e-3, -0.5 + 1e-3, 1e-3), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero) }
            .With(spring);
        Simulation simulation = new(TimeSteps.Every(0.99 * longest), body);
        double most = 0;
        for (int n = 0; n < 20_000; n++)
        {
            simulation.Step();
            most = Math.Max(most, (simulation.Bodies[0].State.Position - new Vector3d(0, -0.5, 0)).Length);
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{most:g2}"));
        Assert.That(most, Is.LessThan(0.01)); // measured 0.0017
    }
}
