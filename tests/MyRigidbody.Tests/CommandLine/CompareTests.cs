using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary><c>compare</c>, and the program without any command.</summary>
public sealed class CompareTests
{
    private static readonly string[] Written =
    [
        "apart.csv", "apart.png", "apart.svg", "energy.png", "energy.svg", "momentum.png", "momentum.svg", "replay.png", "report.html", "rules.png",
        "rules.svg", "summary.json", "trajectory.csv",
    ];

    private static readonly string[] Compared = Search.In<string>(["heavy-top.json", "lab-box.json", "tumbling-slab.json", "fall-with-drag.json"], 4);

    [Test]
    public void Without_a_command_the_labs_scene_is_compared_into_out()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path);

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Error, Is.Empty.Or.StartsWith("note: no font"));
        Assert.That(lab.Output, Does.Contain("limit of spin").And.Contain("damping").And.Contain("frames a second"));
        Assert.That(Directory.GetFiles(folder.File("out")).Select(Path.GetFileName), Is.EquivalentTo(Written));
    }

    [Test]
    public void Summary_shares_add_up_and_pictures_are_pictures()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "compare", Gallery.Lab, "--out", "结果 1");

        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(folder.File("结果 1/summary.json")));
        JsonElement pair = summary.RootElement.GetProperty("pairs")[0];
        double sum = pair.GetProperty("rules").EnumerateArray().Sum(rule => rule.GetProperty("distanceShare").GetDouble());
        byte[] png = File.ReadAllBytes(folder.File("结果 1/apart.png"));
        Assert.That(lab.ExitCode, Is.Zero);
        Assert.That(sum, Is.EqualTo(pair.GetProperty("whole").GetProperty("meanDistance").GetDouble()).Within(1e-13)); // measured 1.1e-14
        Assert.That(png.Take(4), Is.EqualTo(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G' }));
        Assert.That(File.ReadAllText(folder.File("结果 1/apart.svg")), Does.Contain("<svg").And.Contain("</svg>"));
    }

    [Test]
    public void Comparing_twice_gives_the_same_files()
    {
        using TemporaryFolder folder = new();
        string scene = Path.Combine(Gallery.Folder, "lab-box.json");

        LabProcess.Run(folder.Path, "compare", scene, "--out", "a");
        LabProcess.Run(folder.Path, "compare", scene, "--out", "b");

        foreach (string name in Written)
            Assert.That(File.ReadAllBytes(folder.File("b/" + name)).AsSpan().SequenceEqual(File.ReadAllBytes(folder.File("a/" + name))), Is.True, name);
    }

    [TestCaseSource(nameof(Compared))]
    public void Every_scene_of_the_gallery_can_be_compared(string scene)
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "compare", Path.Combine(Gallery.Folder, scene));

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(File.Exists(folder.File("out/summary.json")), Is.True);
    }

    [Test]
    public void A_recording_that_is_repeated_bit_for_bit_is_said_to_be()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "compare", TestData.Physx("c_all_keys.json"));

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Output, Does.Contain("bit for bit"));
        // all of a comparison but the rules, which a recording cannot exchange
        string[] written = [.. Directory.GetFiles(folder.File("out")).Select(Path.GetFileName)!];
        Assert.That(written, Is.EquivalentTo(Written.Where(name => name is not ("apart.csv" or "rules.png" or "rules.svg"))));
    }

    [Test]
    public void A_recording_that_differs_is_reported_with_the_place_and_exits_with_1()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "compare", PartingRecording.In(folder));

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Output, Does.Contain("step " + PartingRecording.PartsAt));
        Assert.That(lab.Error, Does.StartWith("error: ").And.Contain("tolerance"));
    }

    // v = 0.1, then 0.98 · 0.1 + 0.1 m/s; the row's q has the other sign, and its velocities are those of no integrator
    [Test]
    public void A_recorded_script_is_measured_by_its_poses_against_the_labs_integrator()
    {
        using TemporaryFolder folder = new();
        RecordedScript(folder, "0.98");

        LabProcess lab = LabProcess.Run(folder.Path, "compare", "script.json", "--tolerance", "1e-8");

        Assert.That(lab.ExitCode, Is.Zero, lab.Output + lab.Error);
        Assert.That(lab.Output, Does.Contain("orientation │ 0 ").And.Not.Contain("velocity"));
    }

    [TestCase("2", "decay")]
    [TestCase("\"x\"", "script.json: decayPerStep")]
    public void A_recorded_script_that_cannot_be_is_refused_in_a_line(string decay, string error)
    {
        using TemporaryFolder folder = new();
        RecordedScript(folder, decay);

        LabProcess lab = LabProcess.Run(folder.Path, "compare", "script.json");

        Assert.That(lab.ExitCode, Is.EqualTo(2));
        Assert.That(lab.Error.Trim(), Does.StartWith("error: script.json: ").And.Contain(error).And.Not.Contain("\n"));
        Assert.That(Directory.Exists(folder.File("out")), Is.False);
    }

    private static void RecordedScript(TemporaryFolder folder, string decay)
    {
        File.WriteAllText(folder.File("script.json"), $$"""
            { "schema": "lab-script/1", "name": "script", "mass": 1, "boxVertices": [1, 1, 1], "decayPerStep": {{decay}}, "position": [0, 0, 0],
              "rotation": [0, 0, 0, 1], "steps": 2, "dt": [0.02, 0.02], "force": [5, 0, 0, 5, 0, 0], "torque": [0, 0, 0, 0, 0, 0] }
            """);
        File.WriteAllText(folder.File("script.csv"), """
            step,t,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,wakeCounter,asleep
            0,0,0,0,0,0,0,0,1,9,9,9,9,9,9,0,0
            1,0.02,0.002,0,0,0,0,0,-1,9,9,9,9,9,9,0,0
            2,0.04,0.00596,0,0,0,0,0,1,9,9,9,9,9,9,0,0
            """ + "\n");
    }

    [Test]
    public void Help_names_the_commands_and_version_is_the_packages()
    {
        using TemporaryFolder folder = new();

        LabProcess help = LabProcess.Run(folder.Path, "--help"), version = LabProcess.Run(folder.Path, "--version");

        Assert.That(help.Output, Does.Contain("compare").And.Contain("run").And.Contain("cost").And.Contain("choose").And.Contain("integrators"));
        Assert.That(help.ExitCode, Is.Zero);
        Assert.That(version.Output.Trim(), Does.Match(@"^0\.1\.0(\+[0-9a-f]+)?$"));
    }

    [Test]
    public void Integrators_are_those_of_the_catalogue()
    {
        using TemporaryFolder folder = new();

        LabProcess json = LabProcess.Run(folder.Path, "integrators", "--json"), table = LabProcess.Run(folder.Path, "integrators");

        using JsonDocument rows = JsonDocument.Parse(json.Output);
        string[] names = [.. Rules.All.Select(row => row.Name)];
        Assert.That(rows.RootElement.EnumerateArray().Select(row => row.GetProperty("name").GetString()), Is.EqualTo(names));
        Assert.That(names.All(table.Output.Contains), Is.True);
    }
}
