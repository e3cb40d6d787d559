using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>A scene that needs too much memory is refused in one line, before it is allocated where the need is known.</summary>
public sealed class MemoryTests
{
    private const string Crowd = """{ "name": "b", "inertia": { "principal": [1, 2, 3] }, "angularVelocity": [1, 2, 3], "count": 10000000 }""";

    private static readonly TestCaseData[] Large =
    [
        // measured: ten million bodies run with 13 GB and not with 12; 1 GB of it are the states that are written
        Scene("bodies: take about 13", 8e9, 2, Crowd),
        // many kinds, none of them too many by itself
        Scene("bodies: take about", 8e9, 2, [.. Enumerable.Range(0, 300).Select(i => Crowd.Replace("\"b\"", $"\"{i}\""))]),
        Scene("their effects: take about 3.7", 2e9, 20_000, [.. Enumerable.Range(0, 100).Select(i => Body(i, Windows(1000)))]),
        // the state of each step, four times
        Scene("steps: take about 0.75", 0.5e9, 5_000_000, Body(0, string.Empty)),
        Scene("compare takes at most 100 pairs, found 101", 8e9, 2, [.. Enumerable.Range(0, 101).Select(i => Body(i, string.Empty))]),
        Scene("name: must have at most 1000 characters, found 1001", 8e9, 2, Body(0, string.Empty).Replace("\"0\"", $"\"{new string('x', 1001)}\"")),
        // pictures and the page; their memory depends on the fonts and is not estimated
        Scene("out of memory: there are 24 MB", 24e6, 5000, [.. Enumerable.Range(0, 20).Select(i => Body(i, """{ "key": "UpArrow" }"""))]),
    ];

    [TestCaseSource(nameof(Large))]
    public void What_does_not_fit_is_one_line(string expected, double bytes, string command, string scene)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("large.json"), scene);

        LabProcess lab = LabProcess.Run(folder.Path, Limit(bytes), [command, "large.json", .. command == "run" ? ["--every", "0"] : Array.Empty<string>()]);

        Assert.That((lab.ExitCode, lab.Error.Count(letter => letter == '\n')), Is.EqualTo((2, 1)), lab.Error);
        Assert.That(lab.Error, Does.Contain(expected));
        Assert.That(lab.Output.Split('\n'), Has.Length.LessThan(3));
        Assert.That(Directory.EnumerateFiles(folder.Path, "*", SearchOption.AllDirectories).Count(), Is.EqualTo(1));
    }

    [Test]
    public void A_crowd_that_fits_runs()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("crowd.json"), (string)Scene(string.Empty, 0, 2, Crowd.Replace("10000000", "200000")).Arguments[3]!);

        LabProcess lab = LabProcess.Run(folder.Path, Limit(400e6), ["run", "crowd.json", "--every", "0"]);

        Assert.That((lab.ExitCode, lab.Error), Is.EqualTo((0, string.Empty)));
        Assert.That(lab.Output.Count(letter => letter == '\n'), Is.EqualTo(200_001));
    }

    private static Dictionary<string, string> Limit(double bytes) => new() { ["DOTNET_GCHeapHardLimit"] = ((long)bytes).ToString("x", CultureInfo.InvariantCulture) };

    private static TestCaseData Scene(string expected, double bytes, int steps, params string[] bodies)
    {
        string scene = $$"""{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.001, "steps": {{steps}}, "bodies": [ {{string.Join(", ", bodies)}} ] }""";
        string command = expected.Contains("compare") || expected.StartsWith("steps") || expected.StartsWith("out of") ? "compare" : "run";
        return new TestCaseData(expected, bytes, command, scene).SetArgDisplayNames(expected);
    }

    private static string Body(int name, string effects) => $$"""{ "name": "{{name}}", "integrator": "LabEuler", "effects": [ {{effects}} ] }""";

    private static string Windows(int count) =>
        string.Join(", ", Enumerable.Range(0, count).Select(i => string.Create(CultureInfo.InvariantCulture, $$"""{ "force": [1, 0, 0], "from": {{i * 0.01:0.00}}, "to": 100 }""")));
}
