using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Shorter steps under damping and a torque accumulate roundings no faster than they must.</summary>
public sealed class DampingUnderTorqueTests
{
    private const double Time = 20;
    private static readonly decimal[] Spin = [1, 1.125m, 0.875m], Torque = [0.125m, -0.25m, 0.5m];

    private static IEnumerable<object[]> Cases =>
        from moments in new[] { new[] { 1m, 2m, 3m }, [2m, 2m, 3m], [2m, 2m, 2m] }
        from parts in new[] { 16, 128, 1024 }
        select new object[] { moments, parts };

    // measured 2.4e-14, 2.9e-14, 2.5e-14; with two moments equal 5.0e-16 at most, and with three 5.2e-16
    [TestCaseSource(nameof(Cases))]
    public void Error_of_Exact6_with_short_steps_is_little_more_than_roundings(decimal[] moments, int parts)
    {
        (Quaterniond q, Vector3d w) = DampedTop.After(Time, moments, Spin, Torque, 0.25m);
        double step = 0.25 / parts;
        BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(1, Vector(moments)))
        {
            Rule = Rules.Exact6,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector(Spin)),
        }.With(new Torque(Vector(Torque), Vector3d.Zero, Vector3d.Zero, 0, inBody: true)).With(new AngularDamping(0.25));
        BodyState end = Scenery.Run(TimeSteps.Every(step), body, (int)(Time / step));

        double error = Math.Max(Conserved.AngleBetween(end.Orientation, q), Samples.Apart(end.Orientation.RotateInverse(end.AngularVelocity), w));
        TestContext.Out.WriteLine(error);
        Assert.That(error, Is.LessThan(1e-13));
    }

    // e^(−ct) falls to 4e-44: what damping has taken is folded into ω twice on the way. Measured 2.7e-15
    [Test]
    public void Spin_under_a_torque_rests_at_torque_over_damping_however_long()
    {
        BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { Rule = Rules.Exact6 }
            .With(new Torque(new Vector3d(0, 0, 3), Vector3d.Zero, Vector3d.Zero, 0, inBody: true)).With(new AngularDamping(0.25));
        BodyState end = Scenery.Run(TimeSteps.Every(0.125), body, 3200);
        Assert.That(end.AngularVelocity.Z, Is.EqualTo(4).Within(1e-14));
    }

    private static Vector3d Vector(decimal[] v) => new((double)v[0], (double)v[1], (double)v[2]);
}
