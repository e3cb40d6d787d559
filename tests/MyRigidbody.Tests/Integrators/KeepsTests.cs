using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// An integrator of the catalogue conserves what it declares of a freely rotating body; and what it does not declare, it loses.
/// </summary>
public sealed class KeepsTests
{
    private const double Step = 0.02;
    private const int Steps = 20_000;

    private static IEnumerable<object[]> Cases =>
        from rule in Rules.All
        from motion in new[] { "asym_moderate", "plate", "dzhanibekov_1e-3", "sym_top" }
        select new object[] { rule.Name, motion };

    [TestCaseSource(nameof(Cases))]
    public void Angular_momentum_is_kept_where_that_is_declared_and_only_there(string integrator, string motion)
    {
        Keeps keeps = Rules.Named(integrator).Keeps;
        (double length, double vector, _, _) = Drift(integrator, motion);
        TestContext.Out.WriteLine(FormattableString.Invariant($"length {length:g2}, vector {vector:g2}"));
        if (keeps.HasFlag(Keeps.MomentumLength))
            Assert.That(length, Is.LessThan(4e-16 * Steps)); // measured at most 5.3e-12, ExplicitGyroscopic
        else
            Assert.That(vector, Is.GreaterThan(5e-5)); // measured at least 2.8e-4

        if (keeps.HasFlag(Keeps.Momentum))
            Assert.That(vector, Is.LessThan(1e-12)); // measured at most 1.6e-13, Splitting
        else
            Assert.That(vector, Is.GreaterThan(5e-5)); // measured at least 2.8e-4
    }

    [TestCaseSource(nameof(Cases))]
    public void Energy_is_kept_where_that_is_declared_and_only_there(string integrator, string motion)
    {
        Keeps keeps = Rules.Named(integrator).Keeps;
        (_, _, double first, double second) = Drift(integrator, motion);
        TestContext.Out.WriteLine(FormattableString.Invariant($"first half {first:g2}, second half {second:g2}"));
        if (keeps.HasFlag(Keeps.Energy))
            Assert.That(Math.Max(first, second), Is.LessThan(1e-14)); // measured at most 3.6e-15, most of it the state's own rounding
        else if (keeps.HasFlag(Keeps.EnergyBounded))
            Assert.That(second, Is.LessThan(1.1 * first + 1e-13)); // measured at most 1.00 of the first
        else if (keeps.HasFlag(Keeps.Motion))
            Assert.That(second, Is.GreaterThan(1e-9)); // measured at least 2.0e-8
    }

    [TestCaseSource(nameof(Cases))]
    public void Angular_velocity_is_kept_by_integrators_without_a_gyroscopic_term(string integrator, string motion)
    {
        bool isFrozen = Rules.Named(integrator).Keeps == Keeps.AngularVelocity;
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(Step), SolvedScene.Body(ExactCase.Read(motion), integrator));
        Vector3d before = simulation.Bodies[0].State.AngularVelocity;
        simulation.Step(500);
        Assert.That(simulation.Bodies[0].State.AngularVelocity == before, Is.EqualTo(isFrozen));
    }

    private static (double Length, double Vector, double FirstHalf, double SecondHalf) Drift(string integrator, string motion)
    {
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(Step), SolvedScene.Body(ExactCase.Read(motion), integrator));
        Body body = simulation.Bodies[0];
        Vector3d momentum = body.AngularMomentum;
        double energy = body.KineticEnergy, length = 0, vector = 0;
        double[] halves = [0, 0];
        for (int i = 0; i < Steps; i++)
        {
            simulation.Step();
            Vector3d now = body.AngularMomentum;
            length = Math.Max(length, Math.Abs(now.Length / momentum.Length - 1));
            vector = Math.Max(vector, (now - momentum).Length / momentum.Length);
            int half = 2 * i / Steps;
            halves[half] = Math.Max(halves[half], Math.Abs(body.KineticEnergy / energy - 1));
        }

        return (length, vector, halves[0], halves[1]);
    }
}
