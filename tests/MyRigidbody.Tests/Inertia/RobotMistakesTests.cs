using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Inertia;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.SceneFiles;

namespace RigidBodyDynamics.Tests;

/// <summary>Robot descriptions with one common mistake each, and right ones: the mistake is named, and no other.</summary>
public sealed class RobotMistakesTests
{
    private static readonly TestCaseData[] Mistakes =
    [
        Mistake("mistake-triangle.urdf", "upper_arm", "triangle", "no moment can exceed the sum of the other two, and 0.0214 is above 0.00519 + 0.01423 kg m²; the nearest possible tensor is ixx "),
        Mistake("mistake-not-positive.xml", "bracket", "not-positive", "no body has a moment of -0.001958 kg m² about an axis; the nearest possible tensor is ixx "),
        Mistake("mistake-product-signs.urdf", "bracket", "product-signs", "the signs of its products are reversed: ixy is minus the integral of x y"),
        Mistake("mistake-about-origin.urdf", "upper_arm", "about-origin", "it was taken about the origin of the link, and is wanted about the centre of mass; evenly filled it would be ixx 0.01422, iyy 0.01422, izz 0.00144"),
        Mistake("mistake-moved-twice.urdf", "upper_arm", "moved-twice", "it was moved from the origin of the link to the centre of mass once more than it should"),
        Mistake("mistake-kg-mm2.urdf", "hand", "units", "in kg mm² (1 kg mm² is 1e-6 kg m²)?; evenly filled it would be ixx 0.0006, iyy 0.0006, izz 0.0006"),
        Mistake("mistake-grams.urdf", "hand", "mass", "heavier than any metal: grams for kilograms"),
        Mistake("mistake-mesh-in-mm.urdf", "finger", "units", "a geometry in millimetres, whose scale of 0.001 is missing"),
        Mistake("mistake-center-in-mm.urdf", "hand", "center-units", "the centre of mass is 50 m from the origin and the geometry is 0.173 m large: millimetres for metres?"),
        Mistake("mistake-rounded.urdf", "plate", "rounded", "written with too few digits; the nearest possible tensor is ixx 0.00333333333333, iyy 0.00333333333333, izz 0.00666666666667"),
        Mistake("mistake-massless.urdf", "hand", "mass", "mass is 0 kg: a body that moves has a mass above zero"),
        Mistake("mistake-placeholder.urdf", "hand", "placeholder", "three equal moments of 0.001 kg m² are a placeholder, and not a computed value"),
        Mistake("mistake-axes.urdf", "roller", "axes", "its moments are those of the geometry about other axes: y and z exchanged"),
        Mistake("mistake-half-lengths.xml", "plank", "lengths", "it is 0.25 times that of the geometry"),
        Mistake("mistake-order.xml", "bracket", "order", "fullinertia wants xx yy zz xy xz yz"),
        Mistake("mistake-decimal-point.urdf", "upper_arm", "decimal-point", "ixx times 0.1 makes a body of it"),
        Mistake("mistake-degrees.urdf", "bracket", "degrees", "URDF wants radians, and these may be degrees"),
    ];

    [TestCaseSource(nameof(Mistakes))]
    public void Mistake_is_named_and_nothing_else_is_found(string file, string body, string code, string expected)
    {
        (string Body, Finding Finding)[] found = Found(InertiaFile.Read(Robot(file), null));

        Assert.That(found.Select(one => (one.Body, one.Finding.Code)), Is.EqualTo(new[] { (body, code) }));
        Assert.That(found[0].Finding.Text, Does.Contain(expected));
        Assert.That(found[0].Finding.Severity, Is.GreaterThan(Severity.Note));
    }

    [TestCase("right-arm.urdf", 5)]
    [TestCase("right-mesh.urdf", 3)]
    [TestCase("right-quadruped.xml", 6)]
    public void Right_descriptions_are_not_blamed(string file, int bodies)
    {
        InertiaFile read = InertiaFile.Read(Robot(file), null);

        Assert.That(read.Bodies, Has.Count.EqualTo(bodies));
        Assert.That(Found(read), Is.Empty);
        Assert.That(read.Notes.Concat(read.Bodies.SelectMany(body => body.Notes)), Is.Empty);
    }

    [Test]
    public void Every_description_of_ours_is_in_a_list()
    {
        IEnumerable<string?> listed = Mistakes.Select(mistake => (string?)mistake.Arguments[0]).Concat(["right-arm.urdf", "right-mesh.urdf", "right-quadruped.xml"]);

        Assert.That(Directory.GetFiles(TestData.Path("robots")).Select(Path.GetFileName), Is.EquivalentTo(listed));
    }

    [Test]
    public void Geoms_of_an_mjcf_weigh_what_their_shapes_do()
    {
        IReadOnlyList<DescribedBody> bodies = InertiaFile.Read(Robot("right-quadruped.xml"), null).Bodies;
        DescribedBody thigh = bodies.Single(body => body.Name == "thigh"), foot = bodies.Single(body => body.Name == "foot"), tool = bodies.Single(body => body.Name == "tool");
        // steel by its default class; a capsule of 0.2 m between half balls of 0.02 m, along z
        const double R = 0.02, H = 0.2;
        double mass = 7850 * Math.PI * R * R * (H + (4 * R / 3));
        Vector3d capsule = Solids.Capsule(mass, R, H, axis: 2).PrincipalMoments;
        Assert.That(thigh.Mass, Is.EqualTo(mass).Within(1e-15));
        Assert.That((thigh.Tensor.Diagonal - capsule).Length, Is.LessThan(1e-16));
        Assert.That(thigh.Center, Is.EqualTo(new Vector3d(0, 0, -0.1)));
        // 500 kg/m³ for an ellipsoid whose class is named, and a ball of 0.2 kg; a wedge of 24 cm³
        Assert.That(foot.Mass, Is.EqualTo(0.2 + (500 * 4 * Math.PI / 3 * 0.05 * 0.02 * 0.01)).Within(1e-16));
        Assert.That(tool.Mass, Is.EqualTo(0.012).Within(1e-8)); // the mesh is in single precision
    }

    [TestCase("""{ "mass": 1, "inertia": { "principal": [0.000231875699, 0.000147497311, 0.0000786269902] } }""", "triangle")]
    [TestCase("""{ "mass": 0, "inertia": { "principal": [1, 1, 2] } }""", "mass")]
    [TestCase("""{ "mass": 1, "inertia": { "principal": [0.333333, 0.333333, 0.666667] } }""", "rounded")]
    [TestCase("""{ "mass": 1, "inertia": { "principal": [1.11, 100.11, 1.01] } }""", "decimal-point")]
    [TestCase("""{ "mass": 1, "inertia": { "principal": [0, 1, 1] } }""", "not-positive")]
    [TestCase("""{ "mass": 1, "inertia": { "principal": [1, 1, 1] } }""", "placeholder")]
    [TestCase("""{ "mass": 1, "inertia": { "principal": [2000, 3000, 2500] } }""", "units")]
    [TestCase("""{ "mass": 1, "inertia": { "tensor": { "xx": 1, "yy": 1.1, "zz": 1, "xy": 0.3, "xz": 0.3, "yz": 0.3 } } }""", "product-signs")]
    [TestCase("""{ "mass": 2, "centerOfMass": [0.3, 0, 0], "inertia": { "principal": [0.002, 0.24, 0.24] } }""", "about-origin")]
    [TestCase("""{ "mass": 1.559, "inertia": { "tensor": { "xx": 2661.9e-6, "yy": 2302.5e-6, "zz": 1676.359e-6, "xy": -31.029e-6, "xz": 9.34e-6, "yz": 151.466e-6 } } }""", "")]
    [TestCase("""{ "mass": 2, "inertia": { "solidBox": [1, 2, 3] } }""", "")]
    public void Scenes_are_told_the_same(string body, string code)
    {
        using TemporaryFolder folder = new();
        string path = folder.File("s.json");
        File.WriteAllText(path, $$"""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [ {{body.Insert(1, "\"name\": \"b\", ")}} ] }""");

        Assert.That(string.Join(' ', Found(InertiaFile.Read(path, null)).Select(one => one.Finding.Code)), Is.EqualTo(code));
    }

    [TestCase("right-arm.urdf", 4)]
    [TestCase("right-quadruped.xml", 6)]
    [TestCase("mistake-rounded.urdf", 3)]
    [TestCase("mistake-triangle.urdf", 2)]
    public void Scene_of_a_description_is_a_scene(string file, int bodies)
    {
        (string json, IReadOnlyList<string> leftOut) = InertiaScene.Of(InertiaFile.Read(Robot(file), null));
        SceneFile scene = SceneText.Read(json);

        Assert.That(scene.Scene.Bodies, Has.Count.EqualTo(bodies));
        Assert.That(leftOut, Has.Count.EqualTo(file == "right-arm.urdf" || file == "mistake-triangle.urdf" ? 1 : 0));
        foreach (BodyDescription body in scene.Scene.Bodies.Where(_ => file.StartsWith("right", StringComparison.Ordinal)))
        {
            DescribedBody given = InertiaFile.Read(Robot(file), null).Bodies.Single(one => one.Name == body.Name);
            Assert.That(body.Mass.Mass, Is.EqualTo(given.Mass));
            Assert.That(FullMatrix.Apart(FullMatrix.Of(body.Mass.Inertia), FullMatrix.Of(given.InBodyAxes)), Is.LessThan(1e-16)); // of moments below 0.09
        }
    }

    private static (string Body, Finding Finding)[] Found(InertiaFile file) =>
        [.. file.Bodies.SelectMany(body => Diagnosis.Of(body).Select(finding => (body.Name, finding)))];

    private static string Robot(string file) => TestData.Path("robots", file);

    private static TestCaseData Mistake(string file, string body, string code, string expected) => new TestCaseData(file, body, code, expected).SetArgDisplayNames(file);
}
