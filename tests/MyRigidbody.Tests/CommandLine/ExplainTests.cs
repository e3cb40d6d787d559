using System.Text.Json;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

public sealed class ExplainTests
{
    private static readonly object[][] Crowds = Search.In<object[]>([[13, 3], [10, 0]], 2);

    [Test]
    public void Explanation_tells_parts_windows_and_what_is_saved()
    {
        LabProcess run = LabProcess.Run(".", "explain", Repository.Root.File("scenes/lab.json"));
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Assert.That(run.Output, Does.StartWith("MyRigidbody, by LabEuler\n  0 s to 1 s: drift, "));
        Assert.That(run.Output, Does.Contain("\nDefaultRigidbody, by UnityRigidbody\n"));
        Assert.That(run.Output, Does.Match(@"drag \(none in the scene\); saves [0-9.]+ ns of [0-9.]+ ns a step, measured"));
    }

    [Test]
    public void Numbers_of_a_recording_are_those_that_somebody_wrote()
    {
        LabProcess run = LabProcess.Run(".", "explain", TestData.Physx("a_right_drag05_gravity.json"));

        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Assert.That(run.Output, Does.Contain("gravity (0, -9.81, 0) m/s²").And.Contain("angularDrag 0.05 /s, limit 7 rad/s, sleep below 0.005 J/kg"));
    }

    [Test]
    public void Json_has_the_same()
    {
        LabProcess run = LabProcess.Run(".", "explain", Repository.Root.File("scenes/heavy-top.json"), "--json");
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        using JsonDocument json = JsonDocument.Parse(run.Output);
        JsonElement body = json.RootElement.GetProperty("bodies")[0];
        Assert.That(body.GetProperty("integrator").GetString(), Is.EqualTo("Exact"));
        Assert.That(body.GetProperty("stretches")[0].GetProperty("parts")[0].GetString(), Is.EqualTo("free rotation of a body with two equal moments (exact)"));
        Assert.That(body.GetProperty("leftOut")[0].GetProperty("what").GetString(), Is.EqualTo("the general free rotation"));
        Assert.That(body.GetProperty("leftOut")[0].GetProperty("nanosecondsWithIt").GetDouble(), Is.GreaterThan(0));
    }

    [TestCaseSource(nameof(Crowds))]
    public void Of_many_bodies_that_move_differently_the_first_are_measured(int different, int notMeasured)
    {
        using TemporaryFolder folder = new();
        IEnumerable<string> bodies = Enumerable.Range(1, different).Select(i => $$"""{ "name": "b{{i}}", "effects": [{ "gravity": [0, -{{i}}, 0] }] }""");
        File.WriteAllText(folder.File("many.json"), $$"""{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 50, "bodies": [{{string.Join(",", bodies)}}] }""");

        LabProcess run = LabProcess.Run(folder.Path, "explain", "many.json");

        Assert.That(run.ExitCode, Is.Zero, run.Error);
        string[] parts = run.Output.Split("\n\n");
        Assert.That(parts, Has.Length.EqualTo(different));
        Assert.That(parts.Select(part => part.Contains("; saves ")), Is.EqualTo(parts.Select((_, i) => i < 10)));
        Assert.That(parts, Has.All.Contains("left out"));
        Assert.That(
            parts.Count(part => part.Contains("left out (what that saves is measured for the first 10 bodies that move differently):")), Is.EqualTo(notMeasured));
    }
}
