using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>Bad usage and bad input: one line, exit code 2, nothing written.</summary>
public sealed class BadInputTests
{
    private const string Broken = "broken.json", Text = "text.txt", Folder = "a folder";

    private static readonly TestCaseData[] Mistakes =
    [
        Mistake("juggle", "juggle"),
        Mistake("'run'", "run"),
        Mistake("--fast", "run", Gallery.Lab, "--fast"),
        Mistake("missing.json", "run", "missing.json"),
        Mistake("missing.json", "compare", "missing.json"),
        Mistake(Folder, "run", Folder),
        Mistake(Broken, "run", Broken),
        Mistake(Broken, "compare", Broken),
        Mistake($"--integrator: integrator: must be one of {string.Join(", ", Rules.All)}, found Eulr", "run", Gallery.Lab, "--integrator", "Eulr"),
        Mistake("--step: step: must be above zero", "run", Gallery.Lab, "--step", "0"),
        Mistake("found -0.1", "run", Gallery.Lab, "--step", "-0.1"),
        Mistake("found NaN", "run", Gallery.Lab, "--step", "NaN"),
        Mistake("at most 1e9 s", "run", Gallery.Lab, "--step", "1e300"),
        Mistake("soon", "run", Gallery.Lab, "--step", "soon"),
        Mistake("--every: must not be below 0, found -1", "run", Gallery.Lab, "--every", "-1"),
        Mistake(Text + "/out.csv: cannot be written", "run", Gallery.Lab, "--out", Text + "/out.csv"),
        Mistake(Folder + ": is a folder", "run", Gallery.Lab, "--out", Folder),
        Mistake(Text + ": cannot be written", "compare", Gallery.Lab, "--out", Text),
        Mistake("--step: the scene gives a force for every step", "run", TestData.Physx("b_torque_r.json"), "--step", "0.01"),
        Mistake("--error", "choose", Gallery.Lab),
        Mistake("--error: error: must be finite and above zero, found 0", "choose", Gallery.Lab, "--error", "0"),
        Mistake("found NaN", "choose", Gallery.Lab, "--error", "NaN"),
        Mistake("found -1", "choose", Gallery.Lab, "--error", "-1"),
        Mistake("abc", "choose", Gallery.Lab, "--error", "abc"),
        Mistake("missing.json", "choose", "missing.json", "--error", "1"),
        Mistake("bodies[0].effects[0]: must not be given step by step", "choose", TestData.Physx("b_torque_r.json"), "--error", "1"),
        Mistake("bodies[0].effects[0]: must not be given step by step", "cost", Gallery.Lab, TestData.Physx("b_torque_r.json")),
        Mistake(Broken, "cost", Broken),
        Mistake(Text + ": cannot be written", "cost", Path.Combine(Gallery.Folder, "fall-with-drag.json"), "--quick", "--out", Text),
        .. OperatingSystem.IsWindows() ? [] : new[] { Mistake("/dev/no such: is a device", "run", Gallery.Lab, "--out", "/dev/no such") },
    ];

    [TestCaseSource(nameof(Mistakes))]
    public void A_mistake_is_answered_in_one_line_and_nothing_is_written(string expected, string[] arguments)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File(Broken), "{ \"schema\": \"rigid-body-scene/1\", ");
        File.WriteAllText(folder.File(Text), "text");
        Directory.CreateDirectory(folder.File(Folder));

        LabProcess lab = LabProcess.Run(folder.Path, arguments);

        Assert.That(lab.ExitCode, Is.EqualTo(2));
        Assert.That(lab.Error, Does.StartWith("error: "));
        Assert.That(lab.Error.TrimEnd().Split('\n').Length, Is.EqualTo(1), lab.Error);
        Assert.That(lab.Error, Does.Contain(expected));
        Assert.That(lab.Output, Is.Empty);
        Assert.That(Directory.EnumerateFileSystemEntries(folder.Path).Count(), Is.EqualTo(3));
        Assert.That(Directory.EnumerateFileSystemEntries(folder.File(Folder)), Is.Empty);
    }

    [Test]
    public void A_scene_of_Unitys_bodies_alone_has_nothing_to_compare()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("unity.json"), """
            { "schema": "rigid-body-scene/1", "name": "u", "about": "", "step": 0.1, "steps": 2,
              "bodies": [ { "name": "a", "integrator": "UnityRigidbody" } ] }
            """);

        LabProcess lab = LabProcess.Run(folder.Path, "compare", "unity.json");

        Assert.That(lab.ExitCode, Is.EqualTo(2));
        Assert.That(lab.Error, Does.StartWith("error: unity.json: bodies: there is none to compare"));
    }

    private static TestCaseData Mistake(string expected, params string[] arguments) =>
        new TestCaseData(expected, arguments).SetArgDisplayNames(string.Join(' ', arguments.Select(Path.GetFileName)));
}
