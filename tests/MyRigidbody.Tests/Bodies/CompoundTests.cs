using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class CompoundTests
{
    private static readonly Vector3d[] Tetrahedron =
        [new Vector3d(1, 0, 0.2), new Vector3d(-0.5, 1, 0), new Vector3d(0, -0.7, 1.5), new Vector3d(0.3, 0.3, -1)];

    [Test]
    public void Two_half_boxes_make_the_whole_box()
    {
        MassProperties half = Solids.Box(1.5, new Vector3d(1, 2, 1.5));
        MassProperties whole = new Compound().With(half, new Vector3d(5, 6, 7.75)).With(half, new Vector3d(5, 6, 9.25)).ToMassProperties();
        MassProperties box = Solids.Box(3, new Vector3d(1, 2, 3));
        Assert.That(whole.Mass, Is.EqualTo(3));
        Assert.That(whole.CenterOfMass, Is.EqualTo(new Vector3d(5, 6, 8.5)));
        Assert.That(FullMatrix.Apart(FullMatrix.Of(whole.Inertia), FullMatrix.Of(box.Inertia)), Is.LessThan(1e-15)); // measured 0
    }

    [Test]
    public void Box_turned_by_a_quarter_has_its_edges_exchanged()
    {
        Quaterniond quarter = new(1, 0, 0, 1);
        MassProperties turned = new Compound().With(Solids.Box(12, new Vector3d(1, 2, 3)), Vector3d.Zero, quarter).ToMassProperties();
        Vector3d exchanged = Solids.Box(12, new Vector3d(2, 1, 3)).Inertia.Diagonal;
        Assert.That(Apart(turned.Inertia.Diagonal, exchanged), Is.LessThan(2e-14)); // measured 7.1e-15
        Assert.That(turned.Inertia.OffDiagonal.Length, Is.LessThan(5e-15)); // measured 6.7e-16
    }

    [Test]
    public void Parts_turned_and_moved_weigh_as_all_their_points_together() => Property.Holds(
        Gen.Select(Quaternions, Vectors, Quaternions, Vectors),
        t =>
        {
            (Quaterniond q1, Vector3d p1, Quaterniond q2, Vector3d p2) = t;
            MassProperties first = PointMasses.Equal(2, Tetrahedron), second = PointMasses.Equal(3, Tetrahedron);
            MassProperties compound = new Compound().With(first, p1, q1).With(second, p2, q2).ToMassProperties();
            Vector3d[] points = [.. Tetrahedron.Select(r => Placed(r, q1, p1)), .. Tetrahedron.Select(r => Placed(r, q2, p2))];
            MassProperties cloud = PointMasses.Of(points, [.. Enumerable.Repeat(0.5, 4), .. Enumerable.Repeat(0.75, 4)]);
            double size = FullMatrix.Size(FullMatrix.Of(cloud.Inertia));
            return Math.Max(
                FullMatrix.Apart(FullMatrix.Of(compound.Inertia), FullMatrix.Of(cloud.Inertia)) / size,
                Apart(compound.CenterOfMass, cloud.CenterOfMass) / 20);
        },
        1e-14, // measured 1.2e-15
        1000);

    [Test]
    public void Compound_of_compounds_is_the_compound_of_all_parts()
    {
        MassProperties box = Solids.Box(2, new Vector3d(1, 2, 3)), ball = Solids.Sphere(1, 0.5), rod = Solids.Cylinder(0.5, 0.1, 2);
        Vector3d a = new(1, 0, 0), b = new(0, 2, 0), c = new(0, 0, -1);
        MassProperties pair = new Compound().With(box, a).With(ball, b).ToMassProperties();
        MassProperties nested = new Compound().With(pair, Vector3d.Zero).With(rod, c).ToMassProperties();
        MassProperties flat = new Compound().With(box, a).With(ball, b).With(rod, c).ToMassProperties();
        Assert.That(FullMatrix.Apart(FullMatrix.Of(nested.Inertia), FullMatrix.Of(flat.Inertia)), Is.LessThan(1e-14)); // measured 8.9e-16
        Assert.That(Apart(nested.CenterOfMass, flat.CenterOfMass), Is.LessThan(1e-15)); // measured 0
        Assert.That(nested.Mass, Is.EqualTo(3.5));
    }

    private static Vector3d Placed(Vector3d r, Quaterniond q, Vector3d position)
    {
        double[,] m = FullMatrix.Of(q);
        return position + new Vector3d(
            m[0, 0] * r.X + m[0, 1] * r.Y + m[0, 2] * r.Z,
            m[1, 0] * r.X + m[1, 1] * r.Y + m[1, 2] * r.Z,
            m[2, 0] * r.X + m[2, 1] * r.Y + m[2, 2] * r.Z);
    }
}
