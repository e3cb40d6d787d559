using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Rotations stored as r − 1.</summary>
public sealed class SmallTurnTests
{
    [Test]
    public void Length_with_an_error_e_has_the_error_e_squared_after_one_rotation()
    {
        // (3 − |q|²)/2 |q| = 1 − 3/2 e² for |q| = 1 + e
        const double E = 1e-5;
        foreach (Quaterniond one in new Quaterniond[] { new(1, 0, 0, 0), new(0, 1, 0, 0), new(0, 0, 1, 0), new(0, 0, 0, 1), new(0.5, -0.5, 0.5, 0.5) })
        {
            foreach (Quaterniond turn in new[] { new Quaterniond(0, 0, 0, 0), SmallTurn.Of(new Vector3d(1, 2, 2), 3, 0.1) })
            {
                Quaterniond q = (1 + E) * one, lost = default, right = one + turn * one;
                SmallTurn.Add(ref q, ref lost, turn * q);
                Assert.That(Samples.Apart(q, (1 - 1.5 * E * E) * right), Is.LessThan(1e-15)); // measured at most 4.4e-16
            }
        }
    }

    [Test]
    public void Rotation_minus_one_has_all_digits_of_the_smallest_angle()
    {
        // r − 1 = (cos a − 1, sin a · axis) with a half the angle: −a²/2 and a for a tiny one
        Quaterniond r = SmallTurn.Of(new Vector3d(0, 3, 4), 5, 2e-9);
        Assert.That(r.W, Is.EqualTo(-1.25e-17).Within(1e-13).Percent); // measured 2e-16 of it
        Assert.That(r.Y, Is.EqualTo(3e-9).Within(1e-13).Percent);
        Assert.That(r.Z, Is.EqualTo(4e-9).Within(1e-13).Percent);
    }
}
