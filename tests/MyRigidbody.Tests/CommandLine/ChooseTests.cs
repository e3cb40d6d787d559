using System.Globalization;
using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary><c>choose</c>: the cheapest integrator and step for an error.</summary>
public sealed class ChooseTests
{
    private static string Fall => Path.Combine(Gallery.Folder, "fall-with-drag.json");

    [Test]
    public void Answer_is_kept_by_run()
    {
        const double error = 0.05;
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Fall, "--error", "0.05", "--json");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        using JsonDocument json = JsonDocument.Parse(lab.Output);
        JsonElement answer = json.RootElement;
        string step = answer.GetProperty("step").GetDouble().ToString("R", CultureInfo.InvariantCulture);
        string integrator = answer.GetProperty("integrator").GetString()!;
        LabProcess run = LabProcess.Run(folder.Path, "run", Fall, "--integrator", integrator, "--step", step);

        Truth truth = Truth.Of(SceneReader.Read(Fall).Scene);
        double[][] rows = [.. run.Output.TrimEnd().Split('\n').Skip(1)
            .Select(line => line.Split(',').Skip(1).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())];
        foreach (TruthSample sample in truth.Samples)
        {
            double[] row = rows.MinBy(row => Math.Abs(row[1] - (sample.At * truth.BaseStep)))!;
            Assert.That((new Vector3d(row[2], row[3], row[4]) - sample.Bodies[0].Position).Length, Is.LessThan(error));
            Assert.That(
                Conserved.AngleBetween(new Quaterniond(row[5], row[6], row[7], row[8]), sample.Bodies[0].Orientation), Is.LessThan(error));
        }

        Assert.That(answer.GetProperty("reached").GetBoolean(), Is.True);
        Assert.That(answer.GetProperty("measuredError").GetDouble(), Is.LessThan(error));
        Assert.That(answer.GetProperty("secondsPerSimulatedSecond").GetDouble(), Is.GreaterThan(0));
    }

    [Test]
    public void Answer_for_people_names_the_rule_its_step_and_the_next()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Fall, "--error", "0.1");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Error, Is.Empty);
        Assert.That(lab.Output, Does.Contain("cheapest").And.Contain("next").And.Contain("times as much as"));
        Assert.That(Directory.EnumerateFileSystemEntries(folder.Path), Is.Empty);
    }

    [Test]
    public void Error_that_no_step_reaches_is_said_with_the_reason_and_exits_with_1()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Fall, "--error", "1e-17", "--json");

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Error, Does.StartWith("error: ").And.Contain("1E-17").And.Contain("rounding floor"));
        using JsonDocument json = JsonDocument.Parse(lab.Output);
        Assert.That(json.RootElement.GetProperty("reached").GetBoolean(), Is.False);
        Assert.That(json.RootElement.GetProperty("reason").GetString(), Does.StartWith("rounding floor"));
        Assert.That(json.RootElement.GetProperty("runnerUp").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }
}
