using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The motion played in the page, as WebAssembly in Node, equals to the bit the command line's motion of the saved scene.</summary>
public sealed class PlayedBitsTests
{
    private const int Steps = 250, PerBody = 11;

    private static IEnumerable<object[]> Cases()
    {
        foreach (string scene in new[] { "lab", "lab-box", "homework", "t-handle", "rocket", "locked-door" })
            yield return [scene, string.Empty, true];

        foreach (string rule in new[] { "ExplicitEuler", "UnityRigidbody", "Splitting", "RungeKutta4", "Exact", "Exact4", "Exact6" })
            yield return ["lab-box", rule, false];

        yield return ["tumbling-slab", "Exact6", false];
    }

    [TestCaseSource(nameof(Cases))]
    public void Saved_scene_repeats_what_was_played_bit_for_bit(string scene, string rule, bool ownKeys)
    {
        using TemporaryFolder folder = new();
        string played = Play(folder, scene, rule, ownKeys);
        foreach (string mesh in Directory.GetFiles(Root.File("scenes"), "*.obj"))
            File.Copy(mesh, folder.File(Path.GetFileName(mesh)));

        LabProcess run = LabProcess.Run(folder.Path, "run", played + ".json", "--out", "run.csv");
        Assert.That(run.ExitCode, NUnit.Framework.Is.Zero, run.Error);

        double[] rows = [.. MemoryMarshal.Cast<byte, double>(File.ReadAllBytes(played + ".rows"))];
        int width = int.Parse(File.ReadAllText(played + ".txt"), CultureInfo.InvariantCulture);
        Assert.That(rows, Has.Length.EqualTo(Steps * width));

        // bodies of Unity's that the scene has not stand beside those that it has, in the page alone
        string[][] table = [.. File.ReadLines(folder.File("run.csv")).Skip(1).Select(line => line.Split(','))];
        string[] names = [.. table.Select(row => row[0]).Distinct()];
        Assert.That(names, Is.Not.Empty);
        foreach (string name in names)
        {
            double[][] motion = [.. table.Where(row => row[0] == name && row[1] != "0").Select(Pose)];
            Assert.That(motion, Has.Length.EqualTo(Steps));
            int place = Enumerable.Range(0, width / PerBody).FirstOrDefault(body => motion[^1].SequenceEqual(PoseInRow(rows, (Steps - 1) * width, body)), -1);
            Assert.That(place, Is.Not.Negative, $"{name} ends where no body of the page does");
            for (int step = 0; step < Steps; step++)
                Assert.That(PoseInRow(rows, step * width, place), Is.EqualTo(motion[step]), $"{name} after step {step + 1}");
        }
    }

    [Test]
    public void Recording_of_what_was_played_is_repeated_by_compare_bit_for_bit()
    {
        using TemporaryFolder folder = new();
        string played = Play(folder, "lab-box", string.Empty, ownKeys: true);

        LabProcess compare = LabProcess.Run(folder.Path, "compare", played + "-recording.json");

        Assert.That(compare.ExitCode, NUnit.Framework.Is.Zero, compare.Error);
        Assert.That(compare.Output, Does.Contain("bit for bit"));
    }

    /// <summary>Plays in Node; the paths of what came out, without their endings.</summary>
    private static string Play(TemporaryFolder folder, string scene, string rule, bool ownKeys)
    {
        string program = Path.GetDirectoryName(SiteFiles.Built("artifacts/publish/Play/release/wwwroot/_framework/dotnet.js"))!;
        string played = folder.File("played");
        using Process? node = Start([Root.File("tests/MyRigidbody.BrowserTests/played.mjs"), program, Root.File("scenes"), scene, rule, ownKeys ? "true" : "false", Steps.ToString(CultureInfo.InvariantCulture), played]);
        if (node == null)
            Assert.Ignore("node is not on the path");

        string error = node!.StandardError.ReadToEnd();
        node.WaitForExit();
        Assert.That(node.ExitCode, NUnit.Framework.Is.Zero, error);
        return played;
    }

    private static Process? Start(string[] arguments)
    {
        try
        {
            return Process.Start(new ProcessStartInfo("node", arguments) { RedirectStandardError = true });
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return null;
        }
    }

    // px, py, pz, qw, qx, qy, qz, and wx, wy, wz behind the velocity
    private static double[] Pose(string[] row) =>
        [.. row[3..10].Concat(row[13..16]).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];

    private static double[] PoseInRow(double[] rows, int row, int body) => rows[(row + 1 + PerBody * body)..(row + 1 + PerBody * body + 10)];
}
