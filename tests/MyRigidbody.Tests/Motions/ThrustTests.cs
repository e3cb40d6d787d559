using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Forces and torques that are fixed in a body which spins about a principal axis, against its motion in closed form.</summary>
public sealed class ThrustTests
{
    private const double Kilograms = 2, Spin = 1.5, Newton = 3;
    private static readonly Vector3d Moments = new(1, 2, 2.5), Centre = new(0.1, -0.2, 0.3), Z = new(0, 0, 1);

    private static IEnumerable<string> Compositions => ["Splitting", "Exact", "Exact4", "Exact6"];

    [Test]
    public void Thrust_turns_with_the_body_and_its_torque_is_about_the_centre_of_mass()
    {
        // a quarter turn about z takes the body's x to the world's y; the point is 2 m along the body's y from the centre
        MassProperties mass = MassProperties.FromPrincipal(Kilograms, Moments, Quaterniond.Identity, Centre);
        BodyState quarter = BodyState.AtRest;
        quarter.Orientation = new Quaterniond(Math.Sqrt(0.5), 0, 0, Math.Sqrt(0.5));
        Wrench wrench = default;
        new Force(new Vector3d(3, 0, 0), at: Centre + new Vector3d(0, 2, 0), inBody: true).At(Pushes.Now, quarter, mass, ref wrench);
        Assert.That(Apart(wrench.Force, new Vector3d(0, 3, 0)), Is.LessThan(2e-15)); // measured 4.4e-16
        Assert.That(Apart(wrench.TorqueInWorld(quarter.Orientation), new Vector3d(0, 0, -6)), Is.LessThan(2e-15)); // measured 0
    }

    [TestCaseSource(nameof(Compositions))]
    public void Thrust_along_the_axis_of_spin_gives_v_and_x_as_a_constant_force_does(string rule)
    {
        BodyState end = Run(rule, 100, new Force(Newton * Z, at: Centre, inBody: true));
        double a = Newton / Kilograms, t = MeasuredOrder.Time;
        Assert.That(Apart(end.Velocity, a * t * Z), Is.LessThan(2e-15)); // measured 4.4e-16
        Assert.That(Apart(CentreOf(end), 0.5 * a * t * t * Z + Centre), Is.LessThan(4e-15)); // measured 8.9e-16
        Assert.That(Apart(end.AngularVelocity, Spin * Z), Is.LessThan(2e-15)); // measured 0
    }

    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    public void Constant_torque_about_a_principal_axis_of_the_body_lets_the_spin_grow_linearly(string rule)
    {
        const double torque = 0.8;
        BodyState end = Run(rule, 100, new Torque(torque * Z, Vector3d.Zero, Vector3d.Zero, 0, inBody: true));
        (Quaterniond turned, double spin) = Turned(MeasuredOrder.Time, torque / Moments.Z);
        Assert.That(Apart(end.AngularVelocity, spin * Z), Is.LessThan(2e-15)); // measured 4.4e-16
        Assert.That(Conserved.AngleBetween(end.Orientation, turned), Is.LessThan(3e-15)); // measured 6.1e-16
    }

    [TestCase("LabEuler")]
    [TestCase("Splitting")]
    [TestCase("RungeKutta4")]
    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    public void Integrator_keeps_its_order_under_a_thruster_beside_the_centre_of_mass(string rule)
    {
        // along x at a point of the y axis: its torque increases ω about z, and the body moves along an arc
        Force thrust = new(new Vector3d(Newton, 0, 0), at: Centre + new Vector3d(0, -0.5, 0), inBody: true);
        int declared = Rules.Named(rule).Order;
        double order = MeasuredOrder.Of(declared, steps => Run(rule, steps, thrust), Driven(0.5 * Newton / Moments.Z));
        TestContext.Out.WriteLine($"{order:f2}");
        Assert.That(order, Is.EqualTo(declared).Within(0.1)); // measured to 0.01
    }

    /// <summary>φ = ω₀ t + α t²/2, and v and x the integrals of the force along (cos φ, sin φ), by Gauss's rule of two points in 20000 panels.</summary>
    private static BodyState Driven(double acceleration)
    {
        const int panels = 20_000;
        double time = MeasuredOrder.Time, h = time / panels, a = Newton / Kilograms;
        Vector3d v = Vector3d.Zero, x = Centre;
        for (int i = 0; i < 2 * panels; i++)
        {
            double s = h * (i / 2 + 0.5 + (i % 2 - 0.5) / Math.Sqrt(3)), angle = Spin * s + 0.5 * acceleration * s * s;
            Vector3d along = 0.5 * h * a * new Vector3d(Math.Cos(angle), Math.Sin(angle), 0);
            v += along;
            x += (time - s) * along;
        }

        (Quaterniond turned, double spin) = Turned(time, acceleration);
        return new BodyState(x - turned.Rotate(Centre), turned, v, spin * Z);
    }

    private static (Quaterniond Orientation, double Spin) Turned(double time, double acceleration) =>
        (Quaterniond.FromAxisAngle(Z, Spin * time + 0.5 * acceleration * time * time), Spin + acceleration * time);

    private static Vector3d CentreOf(BodyState state) => state.Position + state.Orientation.Rotate(Centre);

    private static BodyState Run<TPush>(string rule, int steps, TPush push) where TPush : struct, IPush
    {
        BodyDescription body = new("body", MassProperties.FromPrincipal(Kilograms, Moments, Quaterniond.Identity, Centre)) { Rule = Rules.Named(rule) };
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Spin * Z);
        return Scenery.Run(TimeSteps.Every(MeasuredOrder.Time / steps, steps), body.With(push), steps);
    }
}
