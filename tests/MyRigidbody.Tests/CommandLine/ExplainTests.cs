using System.Text.Json;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

public sealed class ExplainTests
{
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
}
