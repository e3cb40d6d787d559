using System.Text.Json;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>What cost.js draws: every trial of every motion, and its own few words.</summary>
internal static class CostJson
{
    /// <summary>As JSON that cannot end a script.</summary>
    public static string Of(CostDiagrams section) => JsonSerializer.Serialize(new
    {
        sameCost = Advisor.SameCost,
        words = Words.OfScripts.Where(pair => pair.Key.StartsWith("cost.", StringComparison.Ordinal))
            .ToDictionary(pair => pair.Key, pair => new { en = pair.Value.En, zh = pair.Value.Zh }),
        rules = Rules.All.Select(rule => rule.Name),
        motions = section.Found.Select(found => new
        {
            name = found.Motion.Scene.Name,
            attainable = Rounded(Math.Max(found.Motion.Truth.Floor, found.Motion.Truth.Uncertainty)),
            trials = found.Trials.Where(trial => double.IsFinite(trial.Error)).Select(trial => new object[]
            {
                Index(trial.Rule), Rounded(trial.Step), Rounded(trial.Error), Rounded(trial.Cost),
            }),
            others = found.Motion.IsSolved && found.Motion.Scene.Name == OtherEngine.Motion
                ? OtherEngine.All.Select(engine => new object[] { engine.Name, Rounded(engine.AngleError), Rounded(engine.Cost) })
                : [],
        }),
    });

    // what nobody can see in a diagram of seventeen powers of ten is not written
    private static double Rounded(double value) => double.Parse(value.ToString("G6", System.Globalization.CultureInfo.InvariantCulture), System.Globalization.CultureInfo.InvariantCulture);

    private static int Index(Rule rule) => Rules.All.Select((other, i) => (other, i)).First(pair => pair.other == rule).i;
}
