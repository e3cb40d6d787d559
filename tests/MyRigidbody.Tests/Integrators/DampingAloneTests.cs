using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Damping of one of the two velocities, with nothing else: v = v₀ e^(−ct), ω = ω₀ e^(−ct), of a ball.</summary>
public sealed class DampingAloneTests
{
    private static readonly Vector3d V = new(1, -2, 0.5), W = new(0.3, 0.4, -1.2);

    private static IEnumerable<string> Integrators => Scenery.Integrators;

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_velocity_alone_leaves_the_spin(string integrator)
    {
        BodyState state = Scenery.Run(TimeSteps.Every(0.02), Ball(integrator).With(new LinearDamping(0.3)), 50);
        Assert.That(Samples.Apart(state.Velocity, Math.Exp(-0.3) * V), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(state.AngularVelocity, W), Is.LessThan(Bound(integrator)));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Damping_of_the_spin_alone_leaves_the_velocity(string integrator)
    {
        BodyState state = Scenery.Run(TimeSteps.Every(0.02), Ball(integrator).With(new AngularDamping(0.3)), 50);
        Assert.That(Samples.Apart(state.Velocity, V), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(state.AngularVelocity, Math.Exp(-0.3) * W), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(state.Position, V), Is.LessThan(Bound(integrator)));
    }

    [TestCaseSource(nameof(Integrators))]
    public void Factor_per_step_on_one_velocity_leaves_the_other(string integrator)
    {
        BodyState slower = Scenery.Run(TimeSteps.Every(0.02), Ball(integrator).With(new DecayPerStep(0.98, 1)), 50);
        BodyState turning = Scenery.Run(TimeSteps.Every(0.02), Ball(integrator).With(new DecayPerStep(1, 0.98)), 50);
        Assert.That(Samples.Apart(slower.Velocity, Math.Pow(0.98, 50) * V), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(slower.AngularVelocity, W), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(turning.Velocity, V), Is.LessThan(Bound(integrator)));
        Assert.That(Samples.Apart(turning.AngularVelocity, Math.Pow(0.98, 50) * W), Is.LessThan(Bound(integrator)));
    }

    // measured at most 8.5e-7, 4.8e-12 and 2.7e-15: Unity's computes in single precision, and Runge and Kutta take e^(−ct)
    // by its first terms
    private static double Bound(string integrator) => integrator switch
    {
        "UnityRigidbody" => 2e-6,
        "RungeKutta4" => 5e-11,
        _ => 1e-14,
    };

    private static BodyDescription Ball(string integrator)
    {
        BodyDescription ball = Scenery.Body(integrator).Copy("ball", Solids.Sphere(2, 0.5));
        ball.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, V, W);
        ball.Unity.Drag = 0;
        ball.Unity.AngularDrag = 0;
        return ball;
    }
}
