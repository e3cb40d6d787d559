using System.Collections.Concurrent;
using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts;
using RigidBodyDynamics.Tests.Languages;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>The scripts of the sample are found as their labels say (tests/data/submissions/labels.json).</summary>
public sealed class LabelledScriptTests
{
    private static readonly string[] NotRun = ["compile", "hang", "throw", "memory", "forbidden", "cheat"];
    private static readonly ConcurrentDictionary<string, Lazy<ScriptReport>> Known = [];

    [TestCaseSource(nameof(Labels))]
    public void A_script_is_found_as_it_is_labelled(string id)
    {
        JsonElement label = Labelled().Single(one => Text(one, "id") == id);
        Verdict verdict = Report(Text(label, "file")).Verdict;

        Assert.That(verdict.Outcome, Is.EqualTo(NotRun.Contains(Text(label, "category")) ? Outcome.Refused : Enum.Parse<Outcome>(Text(label, "verdict"), ignoreCase: true)));
        Assert.That(verdict.Findings.Select(finding => finding.Code), Is.SupersetOf(Mistakes(label).Where(code => code != "not-done")));
        if (verdict.Outcome != Outcome.Refused)
        {
            IEnumerable<int> off = Verdict.FiveSteps.Select((step, index) => verdict[step] == Mark.Right ? 0 : index + 1).Where(number => number > 0);
            Assert.That(off, Is.EqualTo(label.GetProperty("steps").EnumerateArray().Select(step => step.GetInt32()).Where(step => step > 0)));
        }

        // shown to Chinese readers: the sentence, and beside it formulas, which belong to no language
        IEnumerable<string> shown = verdict.Findings.SelectMany(finding => finding.Step <= Step.Damping ? [finding.Chinese, finding.Expected, finding.Found] : new[] { finding.Chinese });
        Assert.That(shown.SelectMany(EnglishSentences.In), Is.Empty);
    }

    // Translate and Rotate stand under a TODO of the sheet in two scripts, and f10's loop was put in afterwards
    [TestCaseSource(nameof(Labels))]
    public void Comments_are_counted_as_labelled(string id)
    {
        JsonElement label = Labelled().Single(one => Text(one, "id") == id);
        CommentCoverage comments = Report(Text(label, "file")).Comments;
        double share = comments.Statements == 0 ? 1 : (double)comments.Commented / comments.Statements;

        Assert.That(share, Text(label, "comments") == "full" ? Is.GreaterThan(0.85) : Is.LessThan(0.15)); // measured 0.89 and 0
    }

    /// <summary>What comes of a script of the sample, which is compiled and run once for all tests.</summary>
    internal static ScriptReport Report(string file) => Known.GetOrAdd(file, name => new(() => Runner.Run(("MyRigidbody.cs", File.ReadAllBytes(TestData.Path(["submissions", .. name.Split('/')])))))).Value;

    internal static IEnumerable<string> Files() => Labelled().Select(label => Text(label, "file"));

    private static IEnumerable<string> Mistakes(JsonElement label) => label.GetProperty("mistakes").EnumerateArray().Select(code => code.GetString()!);

    private static IEnumerable<string> Labels() => Labelled().Select(label => Text(label, "id"));

    private static string Text(JsonElement label, string name) => label.GetProperty(name).GetString()!;

    private static IEnumerable<JsonElement> Labelled() =>
        JsonDocument.Parse(File.ReadAllText(TestData.Path("submissions", "labels.json"))).RootElement.EnumerateArray();
}
