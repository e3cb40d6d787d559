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
    public void Answer_for_people_names_the_integrator_its_step_and_the_next_and_goes_body_by_body()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Fall, "--error", "0.1");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Error, Is.Empty);
        Assert.That(lab.Output, Does.Contain("cheapest").And.Contain("next").And.Contain("times as much as"));
        Assert.That(lab.Output, Does.Match("in [0-9]+ of [0-9]+ rounds of measurement").And.Match("To have it: run .*fall-with-drag.json.* --integrator [A-Za-z0-9]+ --step [0-9.E-]+\\n"));
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

        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Promise kept = Promise.Of(folder.File("advised.json"));
        // plain coordinates keep seven digits only of how close the slab comes to its middle axis
        Assert.That(kept.Still, Is.LessThan(0.1 * error)); // measured 3.0e-8
        Assert.That(kept.Error, Is.LessThan(error));
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
        // pushed from 1/3 s on, and from 0.7310585 s on: a step that meets both is shorter than any that is tried
        const string pushed = """{ "name": "NAME", "canTurn": false, "effects": [ { "force": [3, 0, 0], "from": FROM } ] }""";
        string a = pushed.Replace("NAME", "a", StringComparison.Ordinal).Replace("FROM", "0.3333333333333333", StringComparison.Ordinal);
        string b = pushed.Replace("NAME", "b", StringComparison.Ordinal).Replace("FROM", "0.7310585", StringComparison.Ordinal);
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("odd.json"), $$"""{ "schema": "rigid-body-scene/1", "name": "odd", "step": 0.1, "duration": 3, "bodies": [{{a}}, {{b}}] }""");

        LabProcess lab = LabProcess.Run(folder.Path, "choose", "odd.json", "--error", "1e-9");

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Error, Does.StartWith("error: odd.json: no integrator and step keep the error below 1E-09: the step: ")
            .And.EndWith("; none meets all the times at which effects begin and end; body by body they do\n"));
        Assert.That(lab.Output, Does.Contain("All bodies together").And.Contain("in its own step").And.Not.Contain("\"step\": "));
    }

    [Test]
    public void Factor_per_step_is_named_as_the_rate_for_which_the_answer_holds()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "choose", Path.Combine(Gallery.Folder, "lab.json"), "--error", "0.01", "--json");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        using JsonDocument json = JsonDocument.Parse(lab.Output);
        JsonElement rate = json.RootElement.GetProperty("inPlaceOfFactors").EnumerateArray().Single();
        Assert.That(rate.GetProperty("effect").GetString(), Is.EqualTo("bodies[0].effects[3]"));
        Assert.That(rate.GetProperty("linearDamping").GetDouble(), Is.EqualTo(-Math.Log(0.98) / 0.02).Within(1e-14)); // measured 1.3e-15
        Assert.That(json.RootElement.GetProperty("runnerUp").GetProperty("rounds").GetInt32(), Is.GreaterThan(0));
    }

    private static string SlabAndTop(double step, string slab, string top) => string.Create(CultureInfo.InvariantCulture, $$"""
        { "schema": "rigid-body-scene/1", "name": "two", "step": {{step:R}}, "duration": 18, "bodies": [
          { "name": "slab", "integrator": "{{slab}}", "inertia": { "principal": [1, 2, 3] }, "angularVelocityBody": [0.001, 5, 0.001] },
          { "name": "top", "integrator": "{{top}}", "inertia": { "principal": [1, 1, 0.5] },
            "orientation": [0.9689124217106447, 0.24740395925452294, 0, 0], "angularVelocityBody": [0.1, 0, 8],
            "effects": [ { "heavyTop": { "axis": [0, 0, 1], "moment": 3, "up": [0, 0, 1] } } ] } ] }
        """);
}
