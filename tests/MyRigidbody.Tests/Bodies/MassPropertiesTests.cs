using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class MassPropertiesTests
{
    private static readonly Quaterniond Frame = new(0.8, 0.2, -0.4, 0.4);

    [Test]
    public void Tensor_of_a_turned_frame_is_F_diag_F_transposed()
    {
        MassProperties body = MassProperties.FromPrincipal(2, new Vector3d(1, 2, 2.5), Frame, Vector3d.Zero);
        double[,] expected = FullMatrix.Tensor(new Vector3d(1, 2, 2.5), Frame);
        Assert.That(FullMatrix.Apart(FullMatrix.Of(body.Inertia), expected), Is.LessThan(2e-15)); // measured 8.9e-16
    }

    [Test]
    public void Frame_of_any_length_gives_the_same_tensor_and_is_kept_as_given()
    {
        MassProperties one = MassProperties.FromPrincipal(2, new Vector3d(1, 2, 2.5), Frame, Vector3d.Zero);
        MassProperties two = MassProperties.FromPrincipal(2, new Vector3d(1, 2, 2.5), 2 * Frame, Vector3d.Zero);
        Assert.That(FullMatrix.Apart(FullMatrix.Of(one.Inertia), FullMatrix.Of(two.Inertia)), Is.LessThan(2e-15)); // measured 0
        Assert.That(two.PrincipalFrame, Is.EqualTo(2 * Frame));
    }

    [Test]
    public void Inverses_are_those_of_mass_and_moments()
    {
        MassProperties body = MassProperties.FromPrincipal(4, new Vector3d(2, 4, 5));
        Assert.That(body.InverseMass, Is.EqualTo(0.25));
        Assert.That(body.InversePrincipalMoments, Is.EqualTo(new Vector3d(0.5, 0.25, 0.2)));
    }

    [Test]
    public void Centre_of_mass_moves_without_changing_anything_else()
    {
        MassProperties body = MassProperties.FromPrincipal(4, new Vector3d(2, 4, 5), Frame, new Vector3d(9, 9, 9));
        MassProperties moved = body.WithCenterOfMass(new Vector3d(1, 2, 3));
        Assert.That(moved.CenterOfMass, Is.EqualTo(new Vector3d(1, 2, 3)));
        Assert.That(body.CenterOfMass, Is.EqualTo(new Vector3d(9, 9, 9)));
        Assert.That(
            (moved.Mass, moved.PrincipalMoments, moved.PrincipalFrame, moved.Inertia),
            Is.EqualTo((body.Mass, body.PrincipalMoments, body.PrincipalFrame, body.Inertia)));
    }

    [Test]
    public void Isotropic_means_three_equal_moments()
    {
        Assert.That(MassProperties.FromPrincipal(1, new Vector3d(2, 2, 2)).IsIsotropic, Is.True);
        Assert.That(MassProperties.FromPrincipal(1, new Vector3d(2, 2, 2.0000000000000004)).IsIsotropic, Is.False);
        Assert.That(MassProperties.FromPrincipal(1, new Vector3d(2.0000000000000004, 2, 2)).IsIsotropic, Is.False);
        Assert.That(Solids.Box(1, new Vector3d(1, 1, 1)).IsIsotropic, Is.True);
        Assert.That(PointMasses.BoxVertices(1, new Vector3d(1, 1, 1)).IsIsotropic, Is.True);
        Assert.That(Solids.Cylinder(1, 1, 1).IsIsotropic, Is.False);
    }

    [TestCase(0, 1, 1)]
    [TestCase(1, 0, 1)]
    [TestCase(1, 1, 0)]
    [TestCase(-1, 1, 1)]
    [TestCase(1, double.NaN, 1)]
    [TestCase(1, 1, double.PositiveInfinity)]
    [TestCase(1, 1, 2.1)]
    [TestCase(1, 5, 3)]
    [TestCase(4, 1, 2)]
    [TestCase(1, 1, 2 * (1 + 1e-8))]
    public void Impossible_moments_are_refused_by_name_and_value(double x, double y, double z) => Assert.That(
        () => MassProperties.FromPrincipal(1, new Vector3d(x, y, z)),
        Throws.InstanceOf<ArgumentOutOfRangeException>()
            .With.Message.Contains("principal").And.Message.Contains(new Vector3d(x, y, z).ToString()));

    [Test]
    public void Moments_without_a_finite_inverse_are_refused() => Assert.That(
        () => MassProperties.FromPrincipal(1, new Vector3d(1e-320, 1e-320, 1e-320)),
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("1 / principal").And.Message.Contains("Infinity"));

    [TestCase(1, 1, 2)]
    [TestCase(3, 1, 2)]
    [TestCase(1, 4, 3)]
    [TestCase(1, 1, 2 * (1 + 1e-10))]
    [TestCase(1e-18, 1e-18, 2e-18)]
    [TestCase(1e-6, 1, 1)]
    [TestCase(1e300, 1e300, 1e300)]
    public void Flat_and_thin_bodies_are_possible(double x, double y, double z) => Assert.That(
        MassProperties.FromPrincipal(1, new Vector3d(x, y, z)).PrincipalMoments, Is.EqualTo(new Vector3d(x, y, z)));

    [Test]
    public void Flat_plate_of_points_in_a_tilted_plane_is_possible()
    {
        // in a plane the sum of the two moments within is the third, but for roundings
        Vector3d u = Frame.Normalized.Rotate(new Vector3d(1, 0, 0)), v = Frame.Normalized.Rotate(new Vector3d(0, 0.3, 0));
        Vector3d moments = PointMasses.Equal(1, [u, v, -1 * u, -1 * v, u + 2 * v]).PrincipalMoments;
        double[] sorted = [moments.X, moments.Y, moments.Z];
        Array.Sort(sorted);
        Assert.That(sorted[0] + sorted[1], Is.EqualTo(sorted[2]).Within(2e-15)); // measured 0
    }

    [Test]
    public void Points_on_one_axis_are_refused() => Assert.That(
        () => PointMasses.Equal(1, [new Vector3d(1, 0, 0), new Vector3d(2, 0, 0)]),
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("principal").And.Message.Contains("(0, 0.25, 0.25)"));

    [Test]
    public void Tensor_with_a_negative_moment_is_refused_with_its_moments() => Assert.That(
        () => MassProperties.FromTensor(1, new SymmetricMatrix3(new Vector3d(1, 1, 1), new Vector3d(0, 0, 2)), Vector3d.Zero),
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("principal").And.Message.Contains("3"));
}
