using System.Globalization;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>Accuracy against time, a diagram and a table for every motion, and the advice for each accuracy.</summary>
/// <param name="Found">The measurements.</param>
internal sealed record CostDiagrams(IReadOnlyList<CostFindings> Found) : Section
{
    /// <inheritdoc/>
    public override string Kind => "cost";

    public IEnumerable<Of> Motions => Found.Select(found => new Of(found));

    /// <summary>One motion.</summary>
    internal sealed class Of(CostFindings found)
    {
        public string Name => found.Motion.Scene.Name;

        /// <summary>What it is, with what it was compared, and how exactly that can be had.</summary>
        public Word About => new(Before(found.Motion.Scene.About, ". ") + Origin.En, Before(Words.Said(found.Motion.Scene.About).Zh, "。") + Origin.Zh);

        /// <summary>The reference of the comparison, and its uncertainty.</summary>
        public Word Origin => Words.All["cost.origin"].With(Truth, CostTables.Error(found.Motion.Truth.Floor));

        private static string Before(string text, string stop) => text.Length > 0 ? text + stop : text;

        private Word Truth => new(
            found.Motion.Origin,
            found.Motion.IsSolved ? "真实运动：已求解到 20 位" : $"真实运动：由本程序不断缩短步长求得，直到结果不再变化；不确定度 {CostTables.Error(found.Motion.Truth.Uncertainty)}");

        /// <summary>The errors at the heads of the columns.</summary>
        public IEnumerable<string> Bounds => CostFindings.Bounds.Select(bound => bound.ToString("0e+0", CultureInfo.InvariantCulture));

        /// <summary>An integrator, its error and time with a game's step, and its cost for each accuracy.</summary>
        public IEnumerable<string[]> Rows => Rules.All.Select(rule =>
        {
            Trial game = found.InGame(rule);
            IEnumerable<string> costs = CostFindings.Bounds.Select(bound => CostTables.Number(1e6 * (found.Cheapest(rule, bound)?.Cost ?? double.NaN)));
            return (string[])[rule.Name, CostTables.Error(game.Error), CostTables.Number(game.NanosecondsPerStep), CostTables.Number(found.TimesLab(rule)), .. costs];
        });
    }
}
