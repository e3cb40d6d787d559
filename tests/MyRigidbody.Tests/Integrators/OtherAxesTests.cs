using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A body may be described in any axes: its motion in the world is the same.</summary>
public sealed class OtherAxesTests
{
    private static readonly Quaterniond Frame = new Quaterniond(0.9, 0.1, -0.3, 0.2).Normalized, Turned = new Quaterniond(0.7, -0.3, 0.5, 0.4).Normalized;

    private static IEnumerable<object[]> Cases =>
        from name in Scenery.Integrators
        from moments in new[] { new Vector3d(1.5, 2, 2.5), new Vector3d(2, 1, 2), new Vector3d(2, 2, 2) }
        select new object[] { name, moments };

    [TestCaseSource(nameof(Cases))]
    public void Frame_in_the_body_or_in_its_orientation_moves_alike(string integrator, Vector3d moments)
    {
        BodyState inFrame = Run(MassProperties.FromPrincipal(2, moments, Frame, Vector3d.Zero), Turned);
        BodyState turned = Run(MassProperties.FromPrincipal(2, moments), Turned * Frame);
        double bound = integrator == "UnityRigidbody" ? 5e-6 : 1e-13;
        Assert.That(Conserved.AngleBetween(inFrame.Orientation * Frame, turned.Orientation), Is.LessThan(bound)); // measured 2.5e-7 in single precision, 1.4e-14
        Assert.That(Samples.Apart(inFrame.AngularVelocity, turned.AngularVelocity), Is.LessThan(bound)); // measured 1.2e-7 and 2e-14

        BodyState Run(MassProperties mass, Quaterniond orientation)
        {
            BodyDescription body = Scenery.Body(integrator).Copy("b", mass);
            body.Start = new BodyState(Vector3d.Zero, orientation, Vector3d.Zero, new Vector3d(1, -2, 0.5));
            body.With(new Torque(new Vector3d(0.3, -1, 0.7), Vector3d.Zero, Vector3d.Zero, 0, inBody: false));
            return Scenery.Run(TimeSteps.Every(0.02), body, 50);
        }
    }
}
