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
        double[][] rows = [.. run.Output.TrimEnd().Split('\n').Where(line => line.StartsWith("quadratic drag,", StringComparison.Ordinal))
            .Select(line => line.Split(',').Skip(1).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())];
        foreach (double[] row in rows)
        {
            BodyState right = truth.At(0, row[1]);
            Assert.That((new Vector3d(row[2], row[3], row[4]) - right.Position).Length, Is.LessThan(error));
            Assert.That(Conserved.AngleBetween(new Quaterniond(row[5], row[6], row[7], row[8]), right.Orientation), Is.LessThan(error));
        }

        Assert.That(answer.GetProperty("reached").GetBoolean(), Is.True);
        Assert.That(answer.GetProperty("measuredError").GetDouble(), Is.LessThan(error));
        Assert.That(answer.GetProperty("secondsPerSimulatedSecond").GetDouble(), Is.GreaterThan(0));
    }

    [Test]
    public void Answer_for_people_names_the_rule_its_step_and_the_next_and_goes_body_by_body()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Fall, "--error", "0.1");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Error, Is.Empty);
        Assert.That(lab.Output, Does.Contain("cheapest").And.Contain("next").And.Contain("times as much as"));
        Assert.That(lab.Output, Does.Contain("body by body").And.Contain("│ quadratic drag").And.Contain("│ linear damping"));
        Assert.That(lab.Output, Does.Contain("All bodies together").And.Contain("in its own step").And.Contain("whose file then says \"step\": "));
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

    [Test]
    public void Scene_file_with_the_integrators_that_are_advised_body_by_body_keeps_the_error()
    {
        const double error = 1e-6;
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("two.json"), SlabAndTop(0.02, "Exact", "Exact"));

        LabProcess lab = LabProcess.Run(folder.Path, "choose", "two.json", "--error", "1e-6", "--json");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        using JsonDocument json = JsonDocument.Parse(lab.Output);
        JsonElement[] own = [.. json.RootElement.GetProperty("bodies").EnumerateArray()];
        Assert.That(own.Select(body => body.GetProperty("name").GetString()), Is.EqualTo(new[] { "slab", "top" }));
        Assert.That(own.Select(body => body.GetProperty("measuredError").GetDouble()), Is.All.LessThan(error));
        Assert.That(own.Select(body => body.GetProperty("secondsPerSimulatedSecond").GetDouble()), Is.All.GreaterThan(0));
        Assert.That(own[0].GetProperty("step").GetDouble(), Is.GreaterThan(own[1].GetProperty("step").GetDouble()));
        JsonElement sums = json.RootElement.GetProperty("secondsTogether");
        Assert.That(sums.EnumerateObject().Select(sum => sum.Value.GetDouble()), Is.All.GreaterThan(0).And.Exactly(3).Items);

        JsonElement oneStep = json.RootElement.GetProperty("oneStep");
        string[] integrators = [.. oneStep.GetProperty("bodies").EnumerateArray().Select(body => body.GetProperty("integrator").GetString()!)];
        File.WriteAllText(folder.File("advised.json"), SlabAndTop(oneStep.GetProperty("step").GetDouble(), integrators[0], integrators[1]));
        LabProcess run = LabProcess.Run(folder.Path, "run", "advised.json", "--every", "0");

        // the last row of each solution to 20 digits that is at 18 s
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        double[][] ends = [.. run.Output.TrimEnd().Split('\n').Skip(1)
            .Select(line => line.Split(',').Skip(1).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())];
        foreach ((double[] end, string solved) in ends.Zip(new[] { "dzhanibekov_1e-3", "lagrange_top" }))
        {
            Quaterniond right = ExactCase.Read(solved).Samples.Single(sample => sample.Time == 18).Orientation;
            Assert.That(end[1], Is.EqualTo(18).Within(1e-9)); // measured 0
            Assert.That(Conserved.AngleBetween(new Quaterniond(end[5], end[6], end[7], end[8]), right), Is.LessThan(error), solved);
        }
    }

    [Test]
    public void One_body_is_not_chosen_for_twice()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Path.Combine(Gallery.Folder, "heavy-top.json"), "--error", "0.1", "--json");

        using JsonDocument json = JsonDocument.Parse(lab.Output);
        string[] fields = [.. json.RootElement.EnumerateObject().Select(field => field.Name)];
        Assert.That(fields, Does.Contain("integrator").And.Not.Contain("bodies").And.Not.Contain("oneStep").And.Not.Contain("secondsTogether"));
    }

    [Test]
    public void Error_that_is_kept_body_by_body_only_is_said_to_be()
    {
        // 700 m rounded a thousand times are further off than 4e-12 m, and in less than a thousand steps no rule turns the top that well
        const string far = """{ "name": "far", "canTurn": false, "position": [100, 200, 0], "velocity": [30, 0.1, 7] },""";
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("far.json"), SlabAndTop(0.02, "Exact", "Exact").Replace("\"bodies\": [", "\"bodies\": [" + far, StringComparison.Ordinal));

        LabProcess lab = LabProcess.Run(folder.Path, "choose", "far.json", "--error", "4e-12");

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Error, Does.StartWith("error: far.json: no integrator and step keep the error below 4E-12").And.EndWith("; body by body they do\n"));
        Assert.That(lab.Output, Does.Contain("All bodies together").And.Contain("in its own step").And.Not.Contain("\"step\": "));
    }

    private static string SlabAndTop(double step, string slab, string top) => string.Create(CultureInfo.InvariantCulture, $$"""
        { "schema": "rigid-body-scene/1", "name": "two", "step": {{step:R}}, "duration": 18, "bodies": [
          { "name": "slab", "integrator": "{{slab}}", "inertia": { "principal": [1, 2, 3] }, "angularVelocityBody": [0.001, 5, 0.001] },
          { "name": "top", "integrator": "{{top}}", "inertia": { "principal": [1, 1, 0.5] },
            "orientation": [0.9689124217106447, 0.24740395925452294, 0, 0], "angularVelocityBody": [0.1, 0, 8],
            "effects": [ { "heavyTop": { "axis": [0, 0, 1], "moment": 3, "up": [0, 0, 1] } } ] } ] }
        """);
}
