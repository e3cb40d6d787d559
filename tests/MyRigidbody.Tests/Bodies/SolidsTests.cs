using CsCheck;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class SolidsTests
{
    [Test]
    public void Box_has_a_twelfth_of_its_mass_times_the_squares_of_the_other_edges()
    {
        MassProperties box = Solids.Box(12, new Vector3d(1, 2, 3));
        Assert.That(box.PrincipalMoments, Is.EqualTo(new Vector3d(4 + 9, 1 + 9, 1 + 4)));
        Assert.That((box.Mass, box.CenterOfMass, box.PrincipalFrame), Is.EqualTo((12.0, Vector3d.Zero, Quaterniond.Identity)));
    }

    [Test]
    public void Ball_has_two_fifths_of_m_r_squared()
    {
        Vector3d moments = Solids.Sphere(5, 2).PrincipalMoments;
        Assert.That(moments, Is.EqualTo(new Vector3d(8, 8, 8)));
    }

    [Test]
    public void Cylinder_lies_along_y()
    {
        Vector3d moments = Solids.Cylinder(12, 1, 2).PrincipalMoments;
        Assert.That(moments, Is.EqualTo(new Vector3d(3 + 4, 6, 3 + 4)).Using<Vector3d>(Close)); // measured 7.7e-17 of it
    }

    [Test]
    public void Capsule_is_a_cylinder_and_a_ball_cut_in_two()
    {
        // volumes over π: cylinder 3, ball 4/3; a half ball's centre is 3/8 from its flat side
        Vector3d moments = Solids.Capsule(3 + 4.0 / 3, 1, 3).PrincipalMoments;
        double along = 3 * 0.5 + 4.0 / 3 * 0.4;
        double across = 3 * (0.25 + 0.75) + 4.0 / 3 * (0.4 + 2.25 + 2 * 1.5 * 0.375);
        Assert.That(moments, Is.EqualTo(new Vector3d(across, along, across)).Using<Vector3d>(Close)); // measured 0
    }

    [Test]
    public void Capsule_without_a_cylinder_is_a_ball()
    {
        Vector3d moments = Solids.Capsule(5, 2, 1e-18).PrincipalMoments;
        Assert.That(moments, Is.EqualTo(new Vector3d(8, 8, 8)).Using<Vector3d>(Close)); // measured 0
    }

    [Test]
    public void Capsule_of_no_thickness_is_a_rod()
    {
        Vector3d moments = Solids.Capsule(12, 1e-9, 2).PrincipalMoments;
        Assert.That(moments.X, Is.EqualTo(4).Within(1e-7)); // measured 5.3e-9, the thickness
        Assert.That(moments.Y, Is.EqualTo(6e-18).Within(5e-27)); // measured 8.0e-28, the thickness
    }

    // measured, relative: box 1.1e-5, ball 2.4e-4, cylinder 8.3e-5, capsule 2.8e-4
    [TestCaseSource(nameof(Shapes))]
    public void Moments_are_those_of_points_that_fill_the_shape(string name, MassProperties solid, Vector3d box, Predicate<Vector3d> inside)
    {
        SymmetricMatrix3 filled = solid.Mass * FilledShape.Inertia(box, inside);
        double size = FullMatrix.Size(FullMatrix.Of(solid.Inertia));
        Assert.That(FullMatrix.Apart(FullMatrix.Of(solid.Inertia), FullMatrix.Of(filled)) / size, Is.LessThan(1e-3), name);
    }

    [Test]
    public void Moments_grow_with_the_mass_and_with_the_square_of_the_size() => Property.Holds(
        Gen.Select(Gen.Double[0.1, 10], Gen.Double[0.1, 10], Gen.Double[0.1, 10], Gen.Double[0.1, 10]),
        t =>
        {
            (double mass, double scale, double a, double b) = t;
            return new[]
            {
                Ratio(Solids.Box(mass, scale * new Vector3d(a, b, 1)), Solids.Box(1, new Vector3d(a, b, 1))),
                Ratio(Solids.Sphere(mass, scale * a), Solids.Sphere(1, a)),
                Ratio(Solids.Cylinder(mass, scale * a, scale * b), Solids.Cylinder(1, a, b)),
                Ratio(Solids.Capsule(mass, scale * a, scale * b), Solids.Capsule(1, a, b)),
            }.Max(r => Math.Abs(r / (mass * scale * scale) - 1));
        },
        2e-14, // measured 6.7e-16
        500);

    private static double Ratio(MassProperties a, MassProperties b) => a.PrincipalMoments.X / b.PrincipalMoments.X;

    private static bool Close(Vector3d a, Vector3d b) => Samples.Apart(a, b) <= 1e-15 * a.Length;

    private static IEnumerable<TestCaseData> Shapes()
    {
        yield return Case("box", Solids.Box(2, new Vector3d(1, 2, 3)), new Vector3d(0.5, 1, 1.5), _ => true);
        yield return Case("ball", Solids.Sphere(2, 1.5), new Vector3d(1.5, 1.5, 1.5), p => p.LengthSquared <= 1.5 * 1.5);
        yield return Case("cylinder", Solids.Cylinder(2, 0.7, 3), new Vector3d(0.7, 1.5, 0.7), p => p.X * p.X + p.Z * p.Z <= 0.49);
        yield return Case(
            "capsule",
            Solids.Capsule(2, 0.7, 1.8),
            new Vector3d(0.7, 1.6, 0.7),
            p => new Vector3d(p.X, Math.Max(0, Math.Abs(p.Y) - 0.9), p.Z).LengthSquared <= 0.49);

        static TestCaseData Case(string name, MassProperties solid, Vector3d half, Predicate<Vector3d> inside) =>
            new TestCaseData(name, solid, half, inside).SetArgDisplayNames(name);
    }
}
