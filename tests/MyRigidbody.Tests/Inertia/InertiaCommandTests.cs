using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using CsCheck;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Inertia;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests;

/// <summary><c>inertia FILE</c> for ordinary and for hostile files.</summary>
public sealed class InertiaCommandTests
{
    private const string Head = "<robot name=\"r\"><link name=\"a\"><inertial>", Good = "<mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1.5\"/>", Tail = "</inertial></link></robot>";

    [Test]
    public void Table_and_findings_are_printed_and_the_exit_code_says_that_something_is_wrong()
    {
        LabProcess run = LabProcess.Run(".", "inertia", TestData.Path("robots", "mistake-axes.urdf"));

        Assert.That((run.ExitCode, run.Error), Is.EqualTo((1, string.Empty)));
        Assert.That(run.Output, Does.Contain("roller (line 15): doubtful, axes: its moments are those of the geometry about other axes: y and z exchanged"));
        Assert.That(run.Output, Does.EndWith("1 of 3 bodies is wrong or doubtful\n"));
        Assert.That(LabProcess.Run(".", "inertia", TestData.Path("robots", "right-arm.urdf")).ExitCode, Is.Zero);
    }

    [TestCase("docs/inertia.md")]
    [TestCase("docs/inertia.zh.md")]
    public void Page_shows_what_is_printed_and_has_every_code(string page)
    {
        LabProcess run = LabProcess.Run(Root.Path, "inertia", "tests/data/robots/mistake-about-origin.urdf");
        string[] sources = [.. new[] { "Diagnosis.cs", "GeometryDiagnosis.cs", "InertiaFile.cs", "Robots/UrdfReader.cs", "Robots/MjcfReader.cs" }.Select(file => Tree.Text("MyRigidbody.Lab/Input/Inertia/" + file))];
        IEnumerable<string> codes = sources.SelectMany(source => Regex.Matches(source, "(?:Finding|return )\\(\"([a-z-]+)\"").Select(match => match.Groups[1].Value)).Distinct();

        Assert.That(PageText.Block(page, "<!-- inertia -->"), Is.EqualTo(run.Output.TrimEnd('\n').Split('\n')));
        Assert.That(codes.Where(code => !Tree.Text(page).Contains($"`{code}`")), Is.Empty);
    }

    [Test]
    public void Json_has_the_same_and_the_scene_runs()
    {
        using TemporaryFolder folder = new();
        LabProcess run = LabProcess.Run(folder.Path, "inertia", TestData.Path("robots", "right-arm.urdf"), "--json", "--scene", "机械臂 arm.json");
        using JsonDocument json = JsonDocument.Parse(run.Output);
        JsonElement bracket = json.RootElement.GetProperty("bodies")[3];

        Assert.That((run.ExitCode, run.Error), Is.EqualTo((0, "note: 机械臂 arm.json: left out, for no body is like that: world\n")));
        Assert.That(bracket.GetProperty("name").GetString(), Is.EqualTo("bracket"));
        Assert.That(bracket.GetProperty("mass").GetDouble(), Is.EqualTo(2.1));
        Assert.That(bracket.GetProperty("isPossible").GetBoolean(), Is.True);
        Assert.That(bracket.GetProperty("findings").GetArrayLength(), Is.Zero);
        Assert.That(SceneReader.Read(folder.File("机械臂 arm.json")).Scene.Bodies, Has.Count.EqualTo(4));
        Assert.That(LabProcess.Run(folder.Path, "run", "机械臂 arm.json", "--every", "0").ExitCode, Is.Zero);
    }

    [Test]
    public void Mesh_weighs_what_is_said_and_millimetres_are_doubted()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("块 block.obj"), MeshText.Obj(Surface.Box(new Vector3d(10, 20, 30))));
        LabProcess large = LabProcess.Run(folder.Path, "inertia", "块 block.obj"), right = LabProcess.Run(folder.Path, "inertia", "块 block.obj", "--scale", "0.001", "--density", "2700", "--json");
        using JsonDocument json = JsonDocument.Parse(right.Output);

        Assert.That((large.ExitCode, large.Output), Is.EqualTo((1, large.Output)));
        Assert.That(large.Output, Does.Contain("units: the part is 10 m × 20 m × 30 m large; a mesh has no unit, and in millimetres it wants --scale 0.001"));
        Assert.That(right.ExitCode, Is.Zero, right.Output);
        Assert.That(json.RootElement.GetProperty("bodies")[0].GetProperty("mass").GetDouble(), Is.EqualTo(2700 * 6e-6).Within(1e-17));
    }

    [TestCase("1e-200")]
    [TestCase("1e300")]
    public void Mesh_without_a_volume_in_double_precision_is_refused_in_one_line(string scale)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("block.obj"), MeshText.Obj(Surface.Box(new Vector3d(10, 20, 30))));
        LabProcess run = LabProcess.Run(folder.Path, "inertia", "block.obj", "--scale", scale);

        Assert.That((run.ExitCode, run.Output), Is.EqualTo((2, string.Empty)));
        Assert.That(run.Error, Does.Match("^error: block\\.obj: [^\n]+\n$"));
    }

    private static readonly TestCaseData[] Refused =
    [
        Refuse("a.urdf", "", "a.urdf: Root element is missing."),
        Refuse("a.urdf", "<robot", "a.urdf: line 1: "),
        Refuse("a.urdf", "{}", "a.urdf: line 1: "),
        Refuse("a.urdf", "<html/>", "a.urdf: line 1: <html> is neither <robot>, of URDF, nor <mujoco>, of MJCF"),
        Refuse("a.urdf", "<!DOCTYPE r [<!ENTITY a \"lol\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]><robot>&b;</robot>", "has a DOCTYPE, which is not read: what it defines could grow without end"),
        Refuse("a.urdf", "<!DOCTYPE r SYSTEM \"file:///etc/passwd\"><robot/>", "has a DOCTYPE"),
        Refuse("a.urdf", string.Concat(Enumerable.Repeat("<a>", 100_000)), "a.urdf: line 1: elements go deeper than 200"),
        Refuse("a.urdf", "<robot>" + string.Concat(Enumerable.Repeat("<a b=\"\"/>", 600_000)) + "</robot>", "has more than 1000000 elements and attributes"),
        Refuse("a.urdf", Head + "<mass value=\"1,5\"/>" + Good[17..] + Tail, "a.urdf: line 1: mass: value must have finite numbers, found \"1,5\""),
        Refuse("a.urdf", Head + "<mass value=\"NaN\"/>" + Good[17..] + Tail, "mass: value must have finite numbers, found \"NaN\""),
        Refuse("a.urdf", Head + "<mass value=\"1e999\"/>" + Good[17..] + Tail, "mass: value must have finite numbers, found \"1e999\""),
        Refuse("a.urdf", Head + "<mass value=\"${m}\"/>" + Good[17..] + Tail, "found \"${m}\": this is xacro, which must be expanded first"),
        Refuse("a.urdf", Head + "<origin xyz=\"0 0\"/>" + Good + Tail, "origin: xyz must have 3 numbers, found \"0 0\""),
        Refuse("a.urdf", Head + Tail, "inertial: mass is missing"),
        Refuse("a.urdf", Head + Good.Replace("ixx", "Ixx") + Tail, "inertia: ixx is missing"),
        Refuse("a.urdf", Head + Good + "</inertial><collision><geometry><box size=\"1 0 1\"/></geometry></collision></link></robot>", "must"),
        Refuse("a.xml", "<mujoco><worldbody><body><inertial pos=\"0 0 0\" mass=\"1\"/></body></worldbody></mujoco>", "inertial: diaginertia or fullinertia is missing"),
        Refuse("a.xml", "<mujoco><worldbody><body><geom type=\"box\" size=\"1 1\"/></body></worldbody></mujoco>", "geom: size of a box must have 3 numbers, found 2"),
        Refuse("a.xml", "<mujoco><worldbody><body><geom type=\"capsule\" size=\"0.02\" fromto=\"0 0 0 9e30 8e30 1e30\"/><geom size=\"0.1\"/></body></worldbody></mujoco>", "a.xml: line 1: "),
        Refuse("a.xml", "<mujoco><compiler coordinate=\"global\"/></mujoco>", "compiler coordinate=\"global\" is not understood"),
        Refuse("a.xacro", "<robot/>", "is xacro, which must be expanded first"),
        Refuse("a.step", "", "must be a scene (.json), a mesh (.stl, .obj), a URDF (.urdf, .xml) or an MJCF (.xml, .mjcf)"),
        Refuse("a.json", "{", "a.json: line 1"),
        Refuse("a.json", """{ "schema": "rigid-body-scene/1", "bodies": [{ "name": "a", "inertia": { "tensor": { "ixx": 1 } } }] }""", "a.json: bodies[0].inertia.tensor: \"xx\" is missing"),
        Refuse("a.stl", "solid", "a.stl: line 1: must be facet or endsolid, found the end of the file"),
        Refuse("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj: triangles: must be a closed surface"),
    ];

    [TestCaseSource(nameof(Refused))]
    public void What_is_no_description_is_one_line_and_no_scene_is_written(string name, string text, string expected)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File(name), text);
        string said = string.Empty;
        try
        {
            Everything(folder.File(name));
        }
        catch (InputException refused)
        {
            said = refused.Message;
        }

        Assert.That(said, Does.Contain(expected).And.Not.Contains("\n"));
    }

    [Test]
    public void Bad_use_is_one_line_and_exit_code_2()
    {
        using TemporaryFolder folder = new();
        string arm = TestData.Path("robots", "right-arm.urdf");
        File.WriteAllText(folder.File("bad.urdf"), "<robot><link name=\"\u202e\"><inertial/></link></robot>");
        foreach ((string expected, string[] arguments) in new[]
        {
            ("missing.urdf: there is no such file", new[] { "inertia", "missing.urdf" }), ("--mass, --density and --scale are for meshes", ["inertia", arm, "--mass", "2"]),
            ("--scale: must be finite and above zero, found 0", ["inertia", arm, "--scale", "0"]), ("--mass and --density exclude each other", ["inertia", arm, "--mass", "1", "--density", "1"]),
            ("bad.urdf: line 1: inertial: mass is missing", ["inertia", "bad.urdf", "--scene", "o.json"]), ("is what was read, and would be written over", ["inertia", arm, "--scene", arm]),
        })
        {
            LabProcess run = LabProcess.Run(folder.Path, arguments);
            Assert.That((run.ExitCode, run.Output, run.Error.Count(letter => letter == '\n')), Is.EqualTo((2, string.Empty, 1)), run.Error);
            Assert.That(run.Error, Does.StartWith("error: ").And.Contain(expected));
        }

        Assert.That(Directory.GetFiles(folder.Path), Has.Length.EqualTo(1));
    }

    [Test]
    public void Whatever_is_done_to_a_description_the_answer_is_a_report_or_one_line()
    {
        string[] texts = [.. new[] { "right-arm.urdf", "right-quadruped.xml", "mistake-order.xml" }.Select(file => File.ReadAllText(TestData.Path("robots", file)))];
        string[] names = ["f.urdf", "f.xml", "f.xml"];
        using TemporaryFolder folder = new();
        int reports = 0;
        Gen.Select(Gen.Int[0, 2], Gen.Double[0, 1], Gen.Int[0, 30], Gen.String[Gen.Char["<>/=\"'&;# 0123456789.eE-+naif刚\u0000\u001b\ud800"], 0, 6]).Sample(
            edit =>
            {
                (int which, double where, int length, string insert) = edit;
                string text = texts[which];
                int at = (int)(where * text.Length);
                string path = folder.File(names[which]);
                File.WriteAllText(path, text[..at] + insert + text[Math.Min(text.Length, at + length)..], new UTF8Encoding(false));
                try
                {
                    reports += Everything(path).Length > 0 ? 1 : 0;
                    return true;
                }
                catch (InputException refused)
                {
                    return !refused.Message.Contains('\n');
                }
            },
            iter: 2000,
            threads: 1);
        TestContext.Out.WriteLine(reports);
        Assert.That(reports, Is.GreaterThan(100)); // measured 168 of 2000
    }

    private static string Everything(string path)
    {
        InertiaFile file = InertiaFile.Read(path, null);
        try
        {
            InertiaScene.Of(file);
        }
        catch (FellShortException)
        {
            // no body in it is possible
        }

        return new InertiaReport(file).ToJson();
    }

    private static TestCaseData Refuse(string name, string text, string expected) => new TestCaseData(name, text, expected).SetArgDisplayNames(name, expected);
}
