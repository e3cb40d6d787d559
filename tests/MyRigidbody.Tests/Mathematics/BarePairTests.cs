using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Symmetric matrices with one pair of numbers a beside an empty diagonal: eigenvalues a, −a and 0, whatever the size of a.</summary>
public sealed class BarePairTests
{
    private static readonly Vector3d[] Places = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(-1, 0, 0), new(0, -1, 0), new(0, 0, -1)];

    [Test]
    public void Bare_pair_has_both_signs_of_it_and_zero([ValueSource(nameof(Places))] Vector3d place, [Values(1, 1e300, 1e-300)] double size)
    {
        Vector3d found = PrincipalAxes.Of(new SymmetricMatrix3(Vector3d.Zero, size * place), out Quaterniond frame);
        double[] sorted = [found.X / size, found.Y / size, found.Z / size];
        Array.Sort(sorted);
        Assert.That(sorted, Is.EqualTo(new double[] { -1, 0, 1 }).Within(4e-16)); // measured 0
        Assert.That(frame.Length, Is.EqualTo(1).Within(4e-16)); // measured 0
    }

    [Test]
    public void Diagonal_of_any_sign_and_size_stays_as_it_is([Values(1, 1e300, 1e-300)] double size)
    {
        foreach (Vector3d place in Places)
        {
            Vector3d found = PrincipalAxes.Of(new SymmetricMatrix3(size * place, Vector3d.Zero), out Quaterniond frame);
            Assert.That((found, frame), Is.EqualTo((size * place, Quaterniond.Identity)));
        }
    }
}
