using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The solid inside a closed surface, against closed forms and against sums in whole numbers.</summary>
public sealed class ClosedMeshTests
{
    private static readonly Vector3d Edges = new(1, 2, 3);
    private static readonly Surface Box = Surface.Box(Edges);

    [Test]
    public void Surface_of_a_box_is_the_solid_box()
    {
        MassProperties mesh = Solids.Mesh(6, Box.Vertices, Box.Triangles), box = Solids.Box(6, Edges);

        Assert.That(Off(mesh.Inertia, box.Inertia), Is.LessThan(1e-15)); // measured 0
        Assert.That(mesh.CenterOfMass, Is.EqualTo(Vector3d.Zero));
        Assert.That(Solids.MeshOfDensity(1, Box.Vertices, Box.Triangles).Mass, Is.EqualTo(6));
    }

    [Test]
    public void Tetrahedron_has_a_fifth_of_the_moments_of_its_corners()
    {
        // ∫ r rᵀ over a tetrahedron about its centre, per mass: Σ over the corners of r rᵀ / 20
        Vector3d[] corners = [new(1, 0, 0.25), new(-0.5, 1, 0), new(0, -0.75, 1.5), new(0.25, 0.25, -1)];
        MassProperties mesh = Solids.Mesh(20, corners, Surface.Tetrahedron(corners).Triangles), points = PointMasses.Equal(4, corners);

        Assert.That(Off(mesh.Inertia, points.Inertia), Is.LessThan(1e-15)); // measured 0
        Assert.That(Shown((mesh.CenterOfMass - points.CenterOfMass).Length), Is.LessThan(1e-16)); // measured 0
    }

    [TestCase(3)]
    [TestCase(7)]
    [TestCase(1000)]
    public void Prism_has_the_moments_of_a_regular_polygon(int sides)
    {
        const double Radius = 0.3, Height = 2, Mass = 5;
        MassProperties mesh = Solids.Mesh(Mass, Surface.Prism(sides, Radius, Height).Vertices, Surface.Prism(sides, Radius, Height).Triangles);
        // about its axis, with the radius of its corners: m r² (2 + cos(2π/n)) / 6
        double along = Mass * Radius * Radius * (2 + Math.Cos(2 * Math.PI / sides)) / 6, across = along / 2 + Mass * Height * Height / 12;

        Assert.That(Off(mesh.Inertia, new SymmetricMatrix3 { XX = across, YY = along, ZZ = across }), Is.LessThan(2e-15)); // measured 2.6e-16
        double volume = sides * Radius * Radius * Math.Sin(2 * Math.PI / sides) / 2 * Height;
        Assert.That(
            Shown(Solids.MeshOfDensity(1, Surface.Prism(sides, Radius, Height).Vertices, Surface.Prism(sides, Radius, Height).Triangles).Mass - volume),
            Is.EqualTo(0).Within(1e-15)); // measured 5.6e-17
    }

    [Test]
    public void Octahedron_has_a_tenth_of_its_edge_squared_and_finer_balls_come_to_two_fifths()
    {
        Surface eight = Surface.Ball(0);
        Assert.That(Solids.Mesh(1, eight.Vertices, eight.Triangles).PrincipalMoments.X, Is.EqualTo(0.2).Within(1e-16));
        double[] below = [.. Enumerable.Range(3, 3).Select(cuts =>
        {
            Surface ball = Surface.Ball(cuts);
            Vector3d moments = Solids.Mesh(1, ball.Vertices, ball.Triangles).PrincipalMoments;
            Assert.That(Shown((moments - moments.X * new Vector3d(1, 1, 1)).Length), Is.LessThan(1e-15)); // measured 5.6e-17
            return 0.4 - moments.X;
        })];

        // inscribed, so below, and by the square of the edge
        Assert.That(below, Is.All.GreaterThan(0));
        Assert.That(below[0] / below[1], Is.EqualTo(4).Within(0.1)); // measured 3.957
        Assert.That(below[1] / below[2], Is.EqualTo(4).Within(0.03)); // measured 3.989
        TestContext.Out.WriteLine(string.Join(' ', below));
    }

    [TestCase(2, 1e-15)] // 128 triangles; measured 1.3e-16
    [TestCase(5, 1e-15)] // 8192; measured 7.8e-16
    public void Any_surface_agrees_with_whole_numbers(int cuts, double off)
    {
        Quaterniond turn = new Quaterniond(0.9, 0.1, -0.3, 0.2).Normalized;
        Surface ball = Surface.Ball(cuts).Mapped(v => turn.Rotate(Vector3d.Scale(v, new Vector3d(0.1, 2, 0.7))) + new Vector3d(0.3, -4, 1));
        (double volume, Vector3d center, SymmetricMatrix3 inertia) = ball.Exactly();
        MassProperties mesh = Solids.MeshOfDensity(2, ball.Vertices, ball.Triangles);

        Assert.That(Shown(Math.Abs(mesh.Mass / (2 * volume) - 1)), Is.LessThan(off));
        Assert.That(Shown((mesh.CenterOfMass - center).Length), Is.LessThan(2e-15)); // measured 5.2e-16
        Assert.That(Off(mesh.Inertia, 2 * volume * inertia), Is.LessThan(off));
    }

    // the corners are rounded where the mesh stands; what they enclose there is known to all digits
    [TestCase(1e3, 1e-15)] // measured 4.0e-16
    [TestCase(1e6, 1e-15)] // measured 7.0e-20
    [TestCase(1e9, 1e-15)] // measured 2.7e-16
    public void Far_from_the_origin_no_digit_is_lost(double far, double off)
    {
        Surface ball = Surface.Ball(4).Moved(new Vector3d(far, -2 * far, 3 * far));
        (double volume, Vector3d center, SymmetricMatrix3 inertia) = ball.Exactly();
        MassProperties mesh = Solids.MeshOfDensity(1, ball.Vertices, ball.Triangles);

        Assert.That(Shown(Math.Abs(mesh.Mass / volume - 1)), Is.LessThan(off));
        Assert.That(Shown((mesh.CenterOfMass - center).Length / center.Length), Is.LessThan(3e-16)); // measured 0
        Assert.That(Off(mesh.Inertia, volume * inertia), Is.LessThan(off));
    }

    [TestCase(1e-90)]
    [TestCase(1e-6)]
    [TestCase(1e50)]
    public void Size_does_not_matter(double size)
    {
        Surface box = Surface.Box(size * Edges);
        Vector3d moments = Solids.Mesh(1, box.Vertices, box.Triangles).PrincipalMoments, expected = Solids.Box(1, Edges).PrincipalMoments;

        Assert.That(Shown((moments / size / size - expected).Length), Is.LessThan(1e-15)); // measured 2.8e-16
    }

    [Test]
    public void Foil_and_needle_keep_their_moments()
    {
        Vector3d foil = new(1, 1e-9, 1), needle = new(1e-6, 1, 1e-6);
        foreach (Vector3d edges in new[] { foil, needle })
        {
            Surface box = Surface.Box(edges);
            Assert.That(Off(Solids.Mesh(1, box.Vertices, box.Triangles).Inertia, Solids.Box(1, edges).Inertia), Is.LessThan(1e-15)); // measured 1.7e-16
            Vector3d moments = Solids.Mesh(1, box.Vertices, box.Triangles).PrincipalMoments;
            Assert.That(Shown(Math.Abs(moments.Y / Solids.Box(1, edges).PrincipalMoments.Y - 1)), Is.LessThan(1e-15)); // measured 0
        }
    }

    [Test]
    public void Hollow_is_taken_away_and_a_second_piece_is_added()
    {
        Surface outer = Surface.Box(new Vector3d(2, 2, 2)), inner = Surface.Box(new Vector3d(1, 1, 1));
        int[] inwards = [.. Enumerable.Range(0, inner.Triangles.Length).Select(i => 8 + inner.Triangles[i % 3 == 1 ? i + 1 : i % 3 == 2 ? i - 1 : i])];
        MassProperties hollow = Solids.MeshOfDensity(1, [.. outer.Vertices, .. inner.Vertices], [.. outer.Triangles, .. inwards]);
        MassProperties pair = Solids.MeshOfDensity(1, [.. outer.Vertices, .. inner.Moved(new Vector3d(3, 0, 0)).Vertices], [.. outer.Triangles, .. inner.Triangles.Select(i => i + 8)]);

        Assert.That(hollow.Mass, Is.EqualTo(7));
        Assert.That(hollow.PrincipalMoments.X, Is.EqualTo((8 * 4 - 1) / 6.0).Within(2e-15));
        Assert.That(pair.Mass, Is.EqualTo(9));
        Assert.That(pair.CenterOfMass.X, Is.EqualTo(1 / 3.0).Within(1e-15));
        Assert.That(pair.Inertia.YY, Is.EqualTo((32 + 1) / 6.0 + 8 / 9.0 + 64 / 9.0).Within(1e-14));
    }

    private static readonly TestCaseData[] Faults =
    [
        Fault("open", Box.Triangles[3..], "the edge from (-0.5, -1, -1.5) to (0.5, 1, -1.5) is in triangle 1 alone: the surface is open there; 2 more edges are like that"),
        Fault("turned over", [0, 3, 2, .. Box.Triangles[3..]], "is run along in the same direction by triangle 1 and triangle 2: one of them is turned over; 2 more"),
        Fault("inside out", [.. Box.Triangles.Reverse()], "this whole surface is inside out, its volume -6: exchange two corners of every triangle, as in triangle 1, (0.5, -1, 1.5) "),
        Fault("twice the same", [.. Box.Triangles, .. Box.Triangles[..3]], "is in 3 triangles, the first of them triangle 1"),
        Fault("a corner twice", [.. Box.Triangles, 0, 0, 1], "triangle 13 has (-0.5, -1, -1.5) twice"),
        Fault("no such vertex", [0, 2, 8], "must be numbers of vertices from 0 to 7, found 8 in triangle 1"),
        Fault("a negative vertex", [0, -1, 2], "must be numbers of vertices from 0 to 7, found -1 in triangle 1"),
        Fault("two corners", [0, 1], "must have three corners each, found 2"),
        Fault("none", [], "must have three corners each, found 0"),
        Fault("flat", [0, 1, 2, 2, 1, 0], "must enclose a volume, and this surface is flat"),
    ];

    [TestCaseSource(nameof(Faults))]
    public void Broken_surface_is_refused_with_what_says_so(int[] triangles, string expected)
    {
        Assert.That(
            () => Solids.Mesh(1, Box.Vertices, triangles),
            Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("triangles: must ").And.Message.Contains(expected).And.Message.Not.Contains("\n"));
    }

    [Test]
    public void Boxes_that_touch_along_an_edge_are_refused_as_such()
    {
        Surface other = Box.Moved(new Vector3d(1, 2, 0));
        Vector3d[] vertices = [.. Box.Vertices, .. other.Vertices.Where(v => !Box.Vertices.Contains(v))];
        int[] triangles = [.. Box.Triangles, .. other.Triangles.Select(i => Array.IndexOf(vertices, other.Vertices[i]))];

        Assert.That(
            () => Solids.Mesh(1, vertices, triangles),
            Throws.InstanceOf<ArgumentException>().With.Message.Contains("is in 4 triangles").And.Message.Contains("parts that touch along an edge are not one surface"));
    }

    [Test]
    public void Numbers_that_are_none_are_refused_by_name()
    {
        Vector3d[] broken = [.. Box.Vertices];
        broken[5] = new Vector3d(0, double.NaN, 0);

        Assert.That(() => Solids.Mesh(1, broken, Box.Triangles), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("vertices[5]: "));
        Assert.That(() => Solids.Mesh(0, Box.Vertices, Box.Triangles), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("mass: "));
        Assert.That(() => Solids.MeshOfDensity(-1, Box.Vertices, Box.Triangles), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("density: "));
        Assert.That(() => Solids.Mesh(1, null!, Box.Triangles), Throws.ArgumentNullException);
        Assert.That(() => Solids.Mesh(1, Box.Vertices, null!), Throws.ArgumentNullException);
    }

    private static double Off(SymmetricMatrix3 found, SymmetricMatrix3 expected) =>
        Shown(FullMatrix.Apart(FullMatrix.Of(found), FullMatrix.Of(expected)) / Math.Max(expected.XX, Math.Max(expected.YY, expected.ZZ)));

    private static double Shown(double measured)
    {
        TestContext.Out.WriteLine(measured);
        return measured;
    }

    private static TestCaseData Fault(string name, int[] triangles, string expected) => new TestCaseData(triangles, expected).SetArgDisplayNames(name);
}
