using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>The labelled scripts that run, from their text to the verdict.</summary>
internal sealed class LabelledScriptTests
{
    private static readonly string[] ThatRun = ["right", "similar", "behaviour", "incomplete"];

    [Test]
    public void Verdict_steps_and_mistakes_are_as_labelled()
    {
        using JsonDocument labels = JsonDocument.Parse(File.ReadAllText(TestData.Path("submissions", "labels.json")));
        string[] others = [.. labels.RootElement.EnumerateArray().Where(l => ThatRun.Contains(l.GetProperty("category").GetString())).Select(l => Difference(l)).OfType<string>()];
        Assert.That(others, Is.Empty);
    }

    /// <summary>The differences of the verdict from the label.</summary>
    private static string? Difference(JsonElement label)
    {
        string file = label.GetProperty("file").GetString()!;
        Verdict verdict = StudentScripts.LabelledScriptTests.Report(file).Verdict;
        IEnumerable<int> steps = Verdict.FiveSteps.Where(s => verdict[s] != Mark.Right).Select(s => (int)s);
        IEnumerable<string> codes = verdict.Findings.Select(f => f.Code);
        bool isAsLabelled = verdict.Outcome.ToString().ToLowerInvariant() == label.GetProperty("verdict").GetString()
            && steps.SequenceEqual(label.GetProperty("steps").EnumerateArray().Select(s => s.GetInt32()))
            && label.GetProperty("mistakes").EnumerateArray().All(m => codes.Contains(m.GetString()));
        return isAsLabelled ? null : $"{file}: {verdict.Outcome}, steps {string.Join(", ", steps)}, {string.Join(", ", codes)}";
    }
}
