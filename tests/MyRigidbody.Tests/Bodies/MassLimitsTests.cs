using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The lightest and smallest bodies that there can be: those whose inverses are numbers.</summary>
public sealed class MassLimitsTests
{
    // 1 / 5.6e-309 is 1.79e308, just below the largest double; 1 / 5.5e-309 is beyond it
    private const double Smallest = 5.6e-309;
    private const double TooSmall = 5.5e-309;

    [Test]
    public void Lightest_body_has_a_finite_inverse_mass()
    {
        Assert.That(MassProperties.FromPrincipal(Smallest, new Vector3d(1, 1, 1)).InverseMass, Is.EqualTo(1.7857e308).Within(0.001).Percent);
        Assert.That(() => MassProperties.FromPrincipal(TooSmall, new Vector3d(1, 1, 1)), Refuses("1 / mass"));
    }

    [Test]
    public void Smallest_moments_have_finite_inverses()
    {
        Vector3d smallest = Smallest * new Vector3d(1, 1, 1);
        Assert.That(MassProperties.FromPrincipal(1, smallest).InversePrincipalMoments.IsFinite, Is.True);
        foreach (Vector3d axis in new[] { new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1) })
            Assert.That(() => MassProperties.FromPrincipal(1, smallest + (TooSmall - Smallest) * axis), Refuses("1 / principal"));
    }

    [Test]
    public void Bodies_with_two_equal_moments_are_not_isotropic_whichever_two()
    {
        foreach (Vector3d moments in new[] { new Vector3d(2, 2, 1), new Vector3d(2, 1, 2), new Vector3d(1, 2, 2) })
            Assert.That(MassProperties.FromPrincipal(1, moments).IsIsotropic, Is.False, moments.ToString());
    }

    private static NUnit.Framework.Constraints.IResolveConstraint Refuses(string name) =>
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains(name);
}
