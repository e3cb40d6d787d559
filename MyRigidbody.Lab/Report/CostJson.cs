using System.Globalization;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The data of cost.js: every trial of every motion, and its words. Built node by node, because the page in a browser has no reflection.</summary>
internal static class CostJson
{
    /// <summary>As JSON that cannot end a script element.</summary>
    public static string Of(CostDiagrams section) => new JsonObject
    {
        ["sameCost"] = Advisor.SameCost,
        ["words"] = OfWords(Words.OfScripts),
        ["rules"] = List(Rules.All.Select(rule => (JsonNode)rule.Name)),
        ["motions"] = List(section.Found.Select(Of)),
    }.ToJsonString();

    /// <summary>One motion.</summary>
    public static JsonNode Of(CostFindings found) => new JsonObject
    {
        ["name"] = found.Motion.Scene.Name,
        ["attainable"] = Rounded(Math.Max(found.Motion.Truth.Floor, found.Motion.Truth.Uncertainty)),
        ["trials"] = List(found.Trials.Where(trial => double.IsFinite(trial.Error)).Select(trial =>
            (JsonNode)new JsonArray(Index(trial.Rule), Rounded(trial.Step), Rounded(trial.Error), Rounded(trial.Cost)))),
        ["others"] = List(found.Motion.IsSolved && found.Motion.Scene.Name == OtherEngine.Motion
            ? OtherEngine.All.Select(engine => (JsonNode)new JsonArray(Both(Words.Said(engine.Name)), Rounded(engine.AngleError), Rounded(engine.Cost)))
            : []),
    };

    /// <summary>Those words that are about the cost.</summary>
    public static JsonNode OfWords(IEnumerable<KeyValuePair<string, Word>> words) => new JsonObject(
        words.Where(pair => pair.Key.StartsWith("cost", StringComparison.Ordinal)).Select(pair => KeyValuePair.Create(pair.Key, Both(pair.Value))));

    /// <summary>A text in both languages.</summary>
    public static JsonNode? Both(Word word) => new JsonObject { ["en"] = word.En, ["zh"] = word.Zh };

    private static JsonArray List(IEnumerable<JsonNode> nodes) => new([.. nodes]);

    // digits that cannot be seen in a diagram of seventeen powers of ten are not written
    private static double Rounded(double value) => double.Parse(value.ToString("G6", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    private static int Index(Rule rule) => Rules.All.Select((other, i) => (other, i)).First(pair => pair.other == rule).i;
}
