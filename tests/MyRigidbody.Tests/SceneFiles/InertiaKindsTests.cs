using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>Every kind of inertia that a scene may give: what comes out is what a table of moments has (Goldstein, Classical Mechanics, chapter 5).</summary>
public sealed class InertiaKindsTests
{
    // m (3 r² + h²) / 12 across, m r² / 2 along
    [TestCase("""{ "solidCylinder": { "radius": 1, "height": 2 } }""", 7, 6, 7)]
    [TestCase("""{ "solidCylinder": { "radius": 1, "height": 2, "axis": "y" } }""", 7, 6, 7)]
    [TestCase("""{ "solidCylinder": { "radius": 1, "height": 2, "axis": "x" } }""", 6, 7, 7)]
    [TestCase("""{ "solidCylinder": { "radius": 1, "height": 2, "axis": "z" } }""", 7, 7, 6)]
    // of 12 kg a capsule of r = 1, h = 2 has 7.2 kg in the cylinder and 4.8 kg in the ball, 2/5 m r², each half of it 1 + 3/8 from the middle
    [TestCase("""{ "solidCapsule": { "radius": 1, "height": 2 } }""", 14.52, 5.52, 14.52)]
    [TestCase("""{ "solidCapsule": { "radius": 1, "height": 2, "axis": "x" } }""", 5.52, 14.52, 14.52)]
    [TestCase("""{ "solidCapsule": { "radius": 1, "height": 2, "axis": "z" } }""", 14.52, 14.52, 5.52)]
    [TestCase("""{ "tensor": { "xx": 3, "yy": 4, "zz": 5 } }""", 3, 4, 5)]
    [TestCase("""{ "compound": [ { "mass": 6, "inertia": { "solidBox": [1, 2, 1.5] }, "position": [0, 0, 0.75] }, { "mass": 6, "inertia": { "solidBox": [1, 2, 1.5] }, "position": [0, 0, -0.75] } ] }""", 13, 10, 5)]
    public void Shapes_have_the_moments_of_the_table(string inertia, double x, double y, double z)
    {
        MassProperties body = Read((inertia.Contains("compound") ? string.Empty : "\"mass\": 12, ") + $"\"inertia\": {inertia}").Mass;

        Assert.That(body.Mass, Is.EqualTo(12));
        Assert.That(body.CenterOfMass, Is.EqualTo(Vector3d.Zero));
        Assert.That(Samples.Apart(body.Inertia.Diagonal, new Vector3d(x, y, z)), Is.LessThan(1e-14)); // measured 1.8e-15
        Assert.That(body.Inertia.OffDiagonal, Is.EqualTo(Vector3d.Zero));
    }

    [Test]
    public void Off_the_diagonal_stands_minus_the_integral_of_the_product()
    {
        Vector3d[] points = [new(1, 1, 0), new(-1, -1, 0), new(0, 2, 1), new(0, -2, -1), new(1, 0, -1), new(-1, 0, 1)];
        (double xy, double xz, double yz) = (points.Sum(p => p.X * p.Y), points.Sum(p => p.X * p.Z), points.Sum(p => p.Y * p.Z));
        (double xx, double yy, double zz) = (points.Sum(p => p.X * p.X), points.Sum(p => p.Y * p.Y), points.Sum(p => p.Z * p.Z));

        MassProperties body = Read(string.Create(CultureInfo.InvariantCulture, $$"""
            "mass": 6, "inertia": { "tensor": { "xx": {{yy + zz}}, "yy": {{xx + zz}}, "zz": {{xx + yy}}, "xy": {{-xy}}, "xz": {{-xz}}, "yz": {{-yz}} } }
            """)).Mass;

        // the same body, of points
        MassProperties cloud = PointMasses.Equal(6, points);
        Assert.That((xy, xz, yz), Is.EqualTo((2.0, -2.0, 4.0)));
        Assert.That(FullMatrix.Apart(FullMatrix.Of(body.Inertia), FullMatrix.Of(cloud.Inertia)), Is.LessThan(1e-15)); // measured 0
        Assert.That(FullMatrix.Apart(FullMatrix.Tensor(body.PrincipalMoments, body.PrincipalFrame), FullMatrix.Of(cloud.Inertia)), Is.LessThan(2e-14)); // measured 1.8e-15
    }

    [Test]
    public void About_the_origin_is_more_by_the_mass_times_the_square_of_the_way()
    {
        // a rod of 3 kg and 2 m: m l² / 3 about its end, m l² / 12 about its middle
        foreach (string given in new[] { """{ "principal": [4.0001, 0.0001, 4.0001] }""", """{ "tensor": { "xx": 4.0001, "yy": 0.0001, "zz": 4.0001 } }""" })
        {
            MassProperties rod = Read($$""" "mass": 3, "about": "origin", "centerOfMass": [0, 1, 0], "inertia": {{given}} """).Mass;
            Assert.That(rod.CenterOfMass, Is.EqualTo(new Vector3d(0, 1, 0)));
            Assert.That(Samples.Apart(rod.Inertia.Diagonal, new Vector3d(1.0001, 0.0001, 1.0001)), Is.LessThan(1e-15)); // measured 2.2e-16
        }

        // a ball whose centre is off every axis, with products: 2/5 m r² is left about its own
        MassProperties ball = Read("""
            "mass": 2, "about": "origin", "centerOfMass": [1, 2, 3],
            "inertia": { "tensor": { "xx": 26.8, "yy": 20.8, "zz": 10.8, "xy": -4, "xz": -6, "yz": -12 } }
            """).Mass;
        Assert.That(Samples.Apart(ball.Inertia.Diagonal, new Vector3d(0.8, 0.8, 0.8)), Is.LessThan(5e-15)); // measured 6.7e-16
        Assert.That(ball.Inertia.OffDiagonal, Is.EqualTo(Vector3d.Zero));
    }

    [Test]
    public void Parts_of_any_kind_come_together_at_their_centre_of_mass()
    {
        // a hammer: a head of 1.2 kg across the end of a handle of 0.4 kg and 0.3 m, from whose end all is measured
        MassProperties hammer = Read("""
            "inertia": { "compound": [
              { "mass": 0.4, "inertia": { "solidCylinder": { "radius": 0.015, "height": 0.3 } }, "position": [0, 0.15, 0] },
              { "mass": 1.2, "inertia": { "solidBox": [0.12, 0.04, 0.04] }, "position": [0, 0.32, 0] } ] }
            """).Mass;

        double center = (0.4 * 0.15 + 1.2 * 0.32) / 1.6, apart = 0.4 * 1.2 / 1.6 * 0.17 * 0.17;
        double acrossHandle = 0.4 * (3 * 0.015 * 0.015 + 0.09) / 12, alongHandle = 0.4 * 0.015 * 0.015 / 2;
        double acrossHead = 1.2 * (0.12 * 0.12 + 0.04 * 0.04) / 12, alongHead = 1.2 * (0.04 * 0.04 + 0.04 * 0.04) / 12;
        Assert.That(hammer.Mass, Is.EqualTo(1.6).Within(1e-15)); // measured 0
        Assert.That(Samples.Apart(hammer.CenterOfMass, new Vector3d(0, center, 0)), Is.LessThan(1e-16)); // measured 0
        Vector3d expected = new(acrossHandle + alongHead + apart, alongHandle + acrossHead, acrossHandle + acrossHead + apart);
        Assert.That(Samples.Apart(hammer.PrincipalMoments, expected), Is.LessThan(2e-17)); // measured 1.7e-18
    }

    [Test]
    public void A_part_is_turned_and_a_compound_may_be_a_part()
    {
        const string Rod = """{ "mass": 2, "inertia": { "solidCylinder": { "radius": 0.1, "height": 1, "axis": "y" } }, "position": [0, 1, 0], "orientation": [1, 0, 0, 1] }""";
        const string Ball = """{ "mass": 3, "inertia": { "solidSphere": 0.5 }, "position": [1, 0, 0] }""";
        MassProperties flat = Read($$""" "inertia": { "compound": [{{Rod}}, {{Ball}}, { "position": [0, 0, 2] }] } """).Mass;
        MassProperties nested = Read($$""" "inertia": { "compound": [{ "inertia": { "compound": [{{Rod}}, {{Ball}}] } }, { "position": [0, 0, 2] }] } """).Mass;
        // a quarter turn about z lays the rod along x
        MassProperties laid = new Compound()
            .With(Solids.Cylinder(2, 0.1, 1, axis: 0), new Vector3d(0, 1, 0))
            .With(Solids.Sphere(3, 0.5), new Vector3d(1, 0, 0))
            .With(Solids.Box(1, new Vector3d(1, 1, 1)), new Vector3d(0, 0, 2)).ToMassProperties();

        Assert.That((flat.Mass, nested.Mass), Is.EqualTo((6.0, 6.0)));
        Assert.That(FullMatrix.Apart(FullMatrix.Of(flat.Inertia), FullMatrix.Of(laid.Inertia)), Is.LessThan(1e-14)); // measured 0
        Assert.That(FullMatrix.Apart(FullMatrix.Of(nested.Inertia), FullMatrix.Of(laid.Inertia)), Is.LessThan(1e-14)); // measured 8.9e-16
    }

    [Test]
    public void Compounds_may_be_nested_eight_deep()
    {
        Assert.That(Read($"\"inertia\": {Nested(8)}").Mass.Mass, Is.EqualTo(1));
        Assert.That(Error($"\"inertia\": {Nested(9)}"), Does.Contain("compound: must not be nested deeper than 8, found 9"));

        static string Nested(int depth) => depth == 0 ? """{ "solidSphere": 1 }""" : $$"""{ "compound": [{ "inertia": {{Nested(depth - 1)}} }] }""";
    }

    private static BodyDescription Read(string fields) => SceneText.Read(Scene(fields)).Scene.Bodies[0];

    private static string Error(string fields) => SceneText.Error(Scene(fields));

    private static string Scene(string fields) =>
        """{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 3, "bodies": [ { "name": "b", """ + fields + " } ] }";
}
