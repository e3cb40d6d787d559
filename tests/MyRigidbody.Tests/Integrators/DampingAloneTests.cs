using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Damping of one of the two velocities, with nothing else: v = v₀ e^(−ct), ω = ω₀ e^(−ct), of a ball.</summary>
public sealed class DampingAloneTests
{
    private static readonly Vector3d V = new(1, -2, 0.5), W = new(0.3, 0.4, -1.2);

    // 1/s, for one second
    private const double C = 0.3;

    private static IEnumerable<string> Integrators => Scenery.Integrators;

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_velocity_alone_leaves_the_spin(string integrator)
    {
        BodyState Moved(int steps) => Run(integrator, steps, ball => ball.With(new LinearDamping(C)));

        IsExactOrOfItsOrder(integrator, steps => Samples.Apart(Moved(steps).Velocity, Math.Exp(-C) * V));
        Assert.That(Samples.Apart(Moved(50).AngularVelocity, W), Is.LessThan(Rounding(integrator)));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_spin_alone_leaves_the_velocity(string integrator)
    {
        BodyState Moved(int steps) => Run(integrator, steps, ball => ball.With(new AngularDamping(C)));

        IsExactOrOfItsOrder(integrator, steps => Samples.Apart(Moved(steps).AngularVelocity, Math.Exp(-C) * W));
        Assert.That(Samples.Apart(Moved(50).Velocity, V), Is.LessThan(Rounding(integrator)));
        Assert.That(Samples.Apart(Moved(50).Position, V), Is.LessThan(Rounding(integrator)));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Factor_per_step_on_one_velocity_leaves_the_other(string integrator)
    {
        BodyState slower = Run(integrator, 50, ball => ball.With(new DecayPerStep(0.98, 1)));
        BodyState turning = Run(integrator, 50, ball => ball.With(new DecayPerStep(1, 0.98)));
        Assert.That(Samples.Apart(slower.Velocity, Math.Pow(0.98, 50) * V), Is.LessThan(Rounding(integrator)));
        Assert.That(Samples.Apart(slower.AngularVelocity, W), Is.LessThan(Rounding(integrator)));
        Assert.That(Samples.Apart(turning.Velocity, V), Is.LessThan(Rounding(integrator)));
        Assert.That(Samples.Apart(turning.AngularVelocity, Math.Pow(0.98, 50) * W), Is.LessThan(Rounding(integrator)));
    }

    /// <summary>
    /// To rounding; in stages, which take e^(−ct) by its first terms, to twice the first term that is left out, C t v₀ (C h)^p / (p + 1)! with p the
    /// order that the catalogue says.
    /// </summary>
    private static void IsExactOrOfItsOrder(string integrator, Func<int, double> error)
    {
        double coarse = error(50), fine = error(100);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{integrator}: {coarse:g2}, {fine:g2}"));
        if (!Scenery.TakesStages(integrator))
        {
            Assert.That(new[] { coarse, fine }, Is.All.LessThan(Rounding(integrator)));
            return;
        }

        int order = Scenery.Body(integrator).Rule.Order;
        double leftOut = Math.Max(V.Length, W.Length) * C * Math.Pow(C / 50, order) / Enumerable.Range(1, order + 1).Aggregate(1.0, (product, i) => product * i);
        Assert.That(coarse, Is.LessThan(2 * leftOut)); // measured 4.8e-12 below 1.5e-11 of RungeKutta4
        Assert.That(Math.Log2(coarse / fine), Is.EqualTo(order).Within(0.1)); // measured 4.00 of RungeKutta4
    }

    // measured at most 8.5e-7 in single precision, and 2.7e-15
    private static double Rounding(string integrator) => integrator == "UnityRigidbody" ? 2e-6 : 1e-14;

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
        ball.Unity.Drag = 0;
        ball.Unity.AngularDrag = 0;
        return ball;
    }
}
