using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class PointMassesTests
{
    private static readonly Gen<double> Edge = Gen.Double[-3, 3].Select(digits => Math.Pow(10, digits));
    private static readonly Gen<Vector3d> Edges = Gen.Select(Edge, Edge, Edge, (x, y, z) => new Vector3d(x, y, z));

    private static readonly Gen<(double Mass, Vector3d Point)[]> Clouds =
        Gen.Select(Gen.Double[0.1, 10], Vectors).Array[4, 12].Where(cloud => !IsFlatOrThin(cloud));

    [Test]
    public void Vertices_of_a_box_weigh_three_times_the_solid_box_on_every_axis() => Property.Holds(
        Gen.Select(Gen.Double[0.1, 10], Edges),
        t =>
        {
            Vector3d hollow = PointMasses.BoxVertices(t.Item1, t.Item2).PrincipalMoments;
            Vector3d solid = Solids.Box(t.Item1, t.Item2).PrincipalMoments;
            return Largest(hollow.X / solid.X - 3, hollow.Y / solid.Y - 3, hollow.Z / solid.Z - 3);
        },
        1e-14); // measured 1.8e-15

    [Test]
    public void Vertices_of_the_lab_box_have_the_moments_on_paper()
    {
        // m/4 (b² + c²), each an exact binary number
        MassProperties box = PointMasses.BoxVertices(1, new Vector3d(1, 2, 3));
        Assert.That(box.Inertia.Diagonal, Is.EqualTo(new Vector3d(3.25, 2.5, 1.25)));
        Assert.That(box.Inertia.OffDiagonal.IsZero, Is.True);
        Assert.That(Apart(box.PrincipalMoments, new Vector3d(3.25, 2.5, 1.25)), Is.LessThan(1e-15)); // measured 0
        Assert.That((box.Mass, box.CenterOfMass, box.PrincipalFrame), Is.EqualTo((1.0, Vector3d.Zero, Quaterniond.Identity)));
    }

    [Test]
    public void Mesh_that_names_each_corner_three_times_is_the_box_of_eight_corners() => Property.Holds(
        Edges,
        edges =>
        {
            // a cube mesh has four vertices of its own on every face
            double[] sides = [-0.5, 0.5];
            Vector3d[] mesh =
            [
                .. from a in sides
                   from b in sides
                   from c in sides
                   from corner in new[] { new Vector3d(a, b, c), new Vector3d(c, a, b), new Vector3d(b, c, a) }
                   select Vector3d.Scale(corner, edges),
            ];
            MassProperties of24 = PointMasses.Equal(2, mesh), of8 = PointMasses.BoxVertices(2, edges);
            double size = FullMatrix.Size(FullMatrix.Of(of8.Inertia));
            return Largest(
                FullMatrix.Apart(FullMatrix.Of(of24.Inertia), FullMatrix.Of(of8.Inertia)) / size,
                of24.CenterOfMass.Length / edges.Length,
                of24.Mass / 2 - 1);
        },
        4e-15, // measured 9.6e-16
        500);

    [Test]
    public void Inertia_is_the_sum_over_pairs_of_points() => Property.Holds(
        Clouds,
        cloud =>
        {
            MassProperties body = PointMasses.Of([.. cloud.Select(p => p.Point)], [.. cloud.Select(p => p.Mass)]);
            // Lagrange's identity: Σ_{i<j} m_i m_j / M (d·d 1 − d dᵀ), d from point to point; no centre is needed
            SymmetricMatrix3 pairs = default;
            double mass = cloud.Sum(p => p.Mass);
            for (int i = 0; i < cloud.Length; i++)
            {
                for (int j = 0; j < i; j++)
                {
                    Vector3d d = cloud[i].Point - cloud[j].Point;
                    double m = cloud[i].Mass * cloud[j].Mass / mass;
                    pairs += new SymmetricMatrix3(
                        m * new Vector3d(d.Y * d.Y + d.Z * d.Z, d.X * d.X + d.Z * d.Z, d.X * d.X + d.Y * d.Y),
                        -m * new Vector3d(d.Y * d.Z, d.X * d.Z, d.X * d.Y));
                }
            }

            double size = FullMatrix.Size(FullMatrix.Of(pairs));
            return FullMatrix.Apart(FullMatrix.Of(body.Inertia), FullMatrix.Of(pairs)) / size;
        },
        1e-14, // measured 1.1e-15
        1000);

    [Test]
    public void Points_moved_together_keep_their_inertia_and_take_their_centre_along() => Property.Holds(
        Gen.Select(Clouds, Vectors),
        t =>
        {
            ((double Mass, Vector3d Point)[] cloud, Vector3d shift) = t;
            double[] masses = [.. cloud.Select(p => p.Mass)];
            MassProperties here = PointMasses.Of([.. cloud.Select(p => p.Point)], masses);
            MassProperties there = PointMasses.Of([.. cloud.Select(p => p.Point + shift)], masses);
            double size = FullMatrix.Size(FullMatrix.Of(here.Inertia));
            return Largest(
                FullMatrix.Apart(FullMatrix.Of(there.Inertia), FullMatrix.Of(here.Inertia)) / size,
                Apart(there.CenterOfMass, here.CenterOfMass + shift) / 20,
                there.Mass / here.Mass - 1);
        },
        1e-14, // measured 7e-16
        1000);

    [Test]
    public void Principal_frame_of_a_cloud_rebuilds_its_tensor() => Property.Holds(
        Clouds,
        cloud =>
        {
            MassProperties body = PointMasses.Of([.. cloud.Select(p => p.Point)], [.. cloud.Select(p => p.Mass)]);
            double[,] given = FullMatrix.Of(body.Inertia);
            return FullMatrix.Apart(FullMatrix.Tensor(body.PrincipalMoments, body.PrincipalFrame), given) / FullMatrix.Size(given);
        },
        8e-15, // measured 1e-15
        1000);

    [Test]
    public void Equal_shares_add_up_to_the_mass_given()
    {
        Vector3d[] triangle = [new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1)];
        MassProperties body = PointMasses.Equal(7, triangle);
        Assert.That(body.Mass, Is.EqualTo(7).Within(1e-15)); // measured 0
        Assert.That(Apart(body.CenterOfMass, new Vector3d(1.0 / 3, 1.0 / 3, 1.0 / 3)), Is.LessThan(1e-16)); // measured 5.6e-17
    }

    private static double Largest(params double[] errors) => errors.Max(Math.Abs);

    // a cloud close to a line has no inertia about it, and is refused
    private static bool IsFlatOrThin((double Mass, Vector3d Point)[] cloud)
    {
        Vector3d d = cloud[1].Point - cloud[0].Point;
        return cloud.All(p => Vector3d.Cross(p.Point - cloud[0].Point, d).Length < 0.1);
    }
}
