using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// A body that rotates k times as fast has after a kth of the time the same orientation. With k a power of two every number of
/// the second motion is one of the first with another exponent, so the two agree to the last bit: every decision about how a
/// step is computed must compare numbers of the same unit.
/// </summary>
public sealed class UnitOfTimeTests
{
    private static readonly Vector3d[] Spins =
    [
        new(1, 2, -1.5), new(1e-3, 3, 1e-3), new(1e-8, 3, 0), new(1e-3, 1e-3, 2), new(2, 1e-4, 1e-2), new(0.01, 5, -0.3), new(1, 1e-9, 1e-9),
    ];

    // three moments different in both orders, two equal, all equal, a plate and a needle
    [TestCase(1, 2, 2.5)]
    [TestCase(2, 2.5, 1)]
    [TestCase(2, 2, 1)]
    [TestCase(2, 2, 2)]
    [TestCase(1, 2, 3)]
    [TestCase(0.001, 1, 1.0005)]
    public void Unit_of_time_changes_no_bit(double i1, double i2, double i3)
    {
        foreach (Vector3d spin in Spins)
        {
            foreach (double time in new[] { 0.01, 0.3, 2.5, 11, 40, 170 })
            {
                BodyState one = At(time, spin);
                foreach (double k in new[] { 1.0 / (1 << 20), 0.5, 4, 1 << 20 })
                {
                    BodyState other = At(time / k, k * spin);
                    Assert.That(other.Orientation, Is.EqualTo(one.Orientation));
                    Assert.That(other.AngularVelocity, Is.EqualTo(k * one.AngularVelocity));
                }
            }
        }

        BodyState At(double time, Vector3d spin)
        {
            BodyDescription body = new("b", MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3)));
            body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, spin);
            return new FreeMotion(body).At(time);
        }
    }
}
