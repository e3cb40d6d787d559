using System.Globalization;
using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Pages as the command line writes them, into a folder whose name has spaces and Chinese characters.</summary>
internal static class Pages
{
    /// <summary>The scene of the lab, both bodies.</summary>
    public static string Lab(TemporaryFolder folder) => Run(folder, "out/report.html");

    /// <summary>A recording and ours beside it.</summary>
    public static string Recording(TemporaryFolder folder) =>
        Run(folder, "out/report.html", "compare", Path.Combine(AppContext.BaseDirectory, "data", "c_all_keys.json"));

    /// <summary>A scene file of one's own, with <c>run</c>.</summary>
    public static string Scene(TemporaryFolder folder, string name, double step, long steps, params string[] bodies)
    {
        object[] list = [.. bodies.Select((body, i) => new
        {
            name = body,
            inertia = new { solidBox = new[] { 1.0, 2, 3 } },
            position = new[] { 4.0 * i, 0, 0 },
            angularVelocity = new[] { 0.01, 3 + i, 0.01 },
        })];
        File.WriteAllText(folder.File("scene.json"), JsonSerializer.Serialize(new { schema = "rigid-body-scene/1", name, step, steps, bodies = list }));
        return Run(folder, "页 1.html", "run", "scene.json", "--every", "0", "--out", "end.csv", "--report", "页 1.html");
    }

    /// <summary>Accuracy against time for a short motion.</summary>
    public static string Cost(TemporaryFolder folder)
    {
        File.WriteAllText(folder.File("scene.json"), """
            { "schema": "rigid-body-scene/1", "name": "pushed", "step": 0.1, "duration": 1, "bodies": [{
              "name": "top", "inertia": { "principal": [1, 2, 3] }, "angularVelocity": [1, 1.1, 0.9],
              "effects": [{ "torque": { "frame": "world", "constant": [0.3, 0.2, 0.1] } }] }] }
            """);
        return Run(folder, "out/cost.html", "cost", "scene.json", "--quick");
    }

    /// <summary>A row of trajectory.csv by its columns.</summary>
    public static Dictionary<string, double> Row(TemporaryFolder folder, string body, int step)
    {
        string[] lines = File.ReadAllLines(folder.File("out/trajectory.csv"));
        string[] cells = lines.Single(line => line.StartsWith($"{body},{step},", StringComparison.Ordinal)).Split(',');
        return lines[0].Split(',').Zip(cells).Skip(1).ToDictionary(pair => pair.First, pair => double.Parse(pair.Second, CultureInfo.InvariantCulture));
    }

    private static string Run(TemporaryFolder folder, string page, params string[] arguments)
    {
        LabProcess lab = LabProcess.Run(folder.Path, arguments);
        Assert.That(lab.ExitCode, NUnit.Framework.Is.Zero, lab.Error);
        return folder.File(page);
    }
}
