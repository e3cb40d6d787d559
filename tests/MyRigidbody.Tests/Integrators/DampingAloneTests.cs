using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Damping of one of the two velocities, with nothing else: v = v₀ e^(−ct), ω = ω₀ e^(−ct), of a ball.</summary>
public sealed class DampingAloneTests
{
    private static readonly Vector3d V = new(1, -2, 0.5), W = new(0.3, 0.4, -1.2);

    // measured at most 2.7e-15
    private const double Rounding = 1e-14;

    private static IEnumerable<string> Integrators => Scenery.Integrators;

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_velocity_alone_leaves_the_spin(string integrator)
    {
        BodyState Moved(int steps) => Run(integrator, steps, ball => ball.With(new LinearDamping(0.3)));

        IsExactOrOfItsOrder(integrator, steps => Samples.Apart(Moved(steps).Velocity, Math.Exp(-0.3) * V));
        Assert.That(Samples.Apart(Moved(50).AngularVelocity, W), Is.LessThan(Rounding));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_spin_alone_leaves_the_velocity(string integrator)
    {
        BodyState Moved(int steps) => Run(integrator, steps, ball => ball.With(new AngularDamping(0.3)));

        IsExactOrOfItsOrder(integrator, steps => Samples.Apart(Moved(steps).AngularVelocity, Math.Exp(-0.3) * W));
        Assert.That(Samples.Apart(Moved(50).Velocity, V), Is.LessThan(Rounding));
        Assert.That(Samples.Apart(Moved(50).Position, V), Is.LessThan(Rounding));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Factor_per_step_on_one_velocity_leaves_the_other(string integrator)
    {
        BodyState slower = Run(integrator, 50, ball => ball.With(new DecayPerStep(0.98, 1)));
        BodyState turning = Run(integrator, 50, ball => ball.With(new DecayPerStep(1, 0.98)));
        Assert.That(Samples.Apart(slower.Velocity, Math.Pow(0.98, 50) * V), Is.LessThan(Rounding));
        Assert.That(Samples.Apart(slower.AngularVelocity, W), Is.LessThan(Rounding));
        Assert.That(Samples.Apart(turning.Velocity, V), Is.LessThan(Rounding));
        Assert.That(Samples.Apart(turning.AngularVelocity, Math.Pow(0.98, 50) * W), Is.LessThan(Rounding));
    }

    [Test]
    public void Single_precision_leaves_its_own_last_bits()
    {
        BodyState slower = Run("UnityRigidbody", 50, ball => Single(ball).With(new LinearDamping(0.3)));
        BodyState turning = Run("UnityRigidbody", 50, ball => Single(ball).With(new AngularDamping(0.3)));
        double[] apart = [Samples.Apart(slower.Velocity, Math.Exp(-0.3) * V), Samples.Apart(slower.AngularVelocity, W), Samples.Apart(turning.Velocity, V), Samples.Apart(turning.AngularVelocity, Math.Exp(-0.3) * W)];
        Assert.That(apart, Is.All.LessThan(2e-6)); // measured 8.5e-7

        static BodyDescription Single(BodyDescription ball)
        {
            ball.Unity.InDouble = false;
            return ball;
        }
    }

    /// <summary>To rounding, or, as where e^(−ct) is taken by its first terms, an error that falls with the power of the step that the catalogue says.</summary>
    private static void IsExactOrOfItsOrder(string integrator, Func<int, double> error)
    {
        double coarse = error(50), fine = error(100);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{integrator}: {coarse:g2}, {fine:g2}"));
        if (coarse >= Rounding)
            Assert.That(Math.Log2(coarse / fine), Is.EqualTo(Rules.Named(integrator).Order).Within(0.1)); // measured 4.00 of RungeKutta4
    }

    private static BodyState Run(string integrator, int steps, Action<BodyDescription> damp)
    {
        BodyDescription ball = Ball(integrator);
        damp(ball);
        return Scenery.Run(TimeSteps.Every(1.0 / steps), ball, steps);
    }

    private static BodyDescription Ball(string integrator)
    {
        BodyDescription ball = Scenery.Body(integrator).Copy("ball", Solids.Sphere(2, 0.5));
        ball.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, V, W);
        ball.Unity.InDouble = true;
        ball.Unity.Drag = 0;
        ball.Unity.AngularDrag = 0;
        return ball;
    }
}
