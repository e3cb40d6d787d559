using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>The labelled scripts that run, from their text to the verdict.</summary>
internal sealed class LabelledScriptTests
{
    private static readonly string[] ThatRun = ["right", "similar", "behaviour", "incomplete"];

    [Test]
    public void Verdict_steps_and_mistakes_are_as_labelled()
    {
        using ScriptRunner runner = new();
        using JsonDocument labels = JsonDocument.Parse(File.ReadAllText(TestData.Path("submissions", "labels.json")));
        Assert.Multiple(() =>
        {
            foreach (JsonElement label in labels.RootElement.EnumerateArray().Where(l => ThatRun.Contains(l.GetProperty("category").GetString())))
                Check(label, runner);
        });
    }

    private static void Check(JsonElement label, ScriptRunner runner)
    {
        string file = label.GetProperty("file").GetString()!;
        Verdict verdict = runner.Run([new ScriptFile("MyRigidbody.cs", File.ReadAllBytes(TestData.Path(["submissions", .. file.Split('/')])))]).Verdict;
        Assert.That(verdict.Outcome.ToString().ToLowerInvariant(), Is.EqualTo(label.GetProperty("verdict").GetString()), file);
        Assert.That(Verdict.FiveSteps.Where(s => verdict[s] != Mark.Right).Select(s => (int)s), Is.EqualTo(label.GetProperty("steps").EnumerateArray().Select(s => s.GetInt32())), file);
        Assert.That(verdict.Findings.Select(f => f.Code), Is.SupersetOf(label.GetProperty("mistakes").EnumerateArray().Select(m => m.GetString())), file);
    }
}
