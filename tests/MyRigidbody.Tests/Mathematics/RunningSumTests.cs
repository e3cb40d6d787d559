using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Sums that keep what they round away, and what moves by them.</summary>
public sealed class RunningSumTests
{
    [Test]
    public void Thousand_additions_below_the_last_bit_add_up()
    {
        double sum = 1, lost = 0, tiny = Math.ScaleB(1, -60);
        for (int i = 0; i < 1024; i++)
            RunningSum.Add(ref sum, ref lost, tiny);
        Assert.That(sum, Is.EqualTo(1 + Math.ScaleB(1, -50)));
        Assert.That(lost, Is.Zero);
    }

    // measured at most 2 (plain sums: 131 to 136,000)
    [TestCase("Exact", 0.1)]
    [TestCase("Exact", 0.01)]
    [TestCase("Exact", 0.001)]
    [TestCase("Exact4", 0.01)]
    [TestCase("Exact6", 0.001)]
    [TestCase("Splitting", 0.01)]
    public void Constant_force_moves_a_body_to_the_last_bits_however_many_steps_it_takes(string integrator, double step)
    {
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1.3, 1)) { Rule = Rules.Named(integrator) }.With(new Force(new Vector3d(2.03, 0, 0)));
        body.Start = new BodyState(new Vector3d(1, 0, 0), Quaterniond.Identity, new Vector3d(0.7, 0, 0), Vector3d.Zero);
        Simulation simulation = new(TimeSteps.Every(step), body);
        double worst = 0;
        for (int i = 1; i <= 20; i++)
        {
            simulation.Step((long)Math.Round(5 / step));
            // decimals of 28 digits
            decimal t = 5 * i, a = 2.03m / 1.3m;
            BodyState found = simulation.Bodies[0].State;
            worst = Math.Max(worst, LastBits(found.Velocity.X, (double)(0.7m + a * t)));
            worst = Math.Max(worst, LastBits(found.Position.X, (double)(1 + 0.7m * t + a * t * t / 2)));
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} last bits"));
        Assert.That(worst, Is.LessThan(4));
    }

    [Test]
    public void Gravity_and_damping_taken_step_by_step_lose_no_digits()
    {
        // v = v₀ + g t, x = v₀ t + g t²/2; and with c = 0.3 the closed form that one step takes
        foreach (double damping in new[] { 0, 0.3 })
        {
            BodyDescription body = new BodyDescription("b", Solids.Sphere(1.3, 1)).With(new Gravity(new Vector3d(-9.81, 0, 0)));
            body = damping > 0 ? body.With(new LinearDamping(damping)) : body;
            body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(0.7, 0, 0), Vector3d.Zero);
            Simulation stepped = Scenery.Stepped(TimeSteps.Every(1e-3), body);
            stepped.Step(100_000);
            BodyState right = new FreeMotion(body).At(100), found = stepped.Bodies[0].State;
            TestContext.Out.WriteLine(FormattableString.Invariant(
                $"{LastBits(found.Position.X, right.Position.X):g2} and {LastBits(found.Velocity.X, right.Velocity.X):g2} last bits with damping {damping}"));
            Assert.That(LastBits(found.Position.X, right.Position.X), Is.LessThan(4)); // measured 1
            Assert.That(LastBits(found.Velocity.X, right.Velocity.X), Is.LessThan(4)); // measured 1
        }
    }

    private static double LastBits(double found, double right) =>
        Math.Abs(found - right) / (Math.BitIncrement(Math.Abs(right)) - Math.Abs(right));
}
