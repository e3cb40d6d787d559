using System.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>Figures and survivors, as a page and as lines.</summary>
internal static class Report
{
    /// <summary>The share of mutants that tests other than the golden ones notice.</summary>
    public static double Share(IEnumerable<Outcome> outcomes) => Share(Counted(outcomes), IsKilled);

    /// <summary>Mutants that were ones, killed ones, and what else is counted, by folder.</summary>
    public static string Figures(IReadOnlyCollection<Outcome> outcomes)
    {
        StringBuilder table = new("| folder | mutants | killed | of these by a time limit | killed | with the golden hash |\n| --- | ---: | ---: | ---: | ---: | ---: |\n");
        foreach (IGrouping<string, Outcome> folder in Counted(outcomes).GroupBy(outcome => outcome.Mutant.Folder).OrderBy(group => group.Key, StringComparer.Ordinal))
            table.Append(Row(folder.Key, [.. folder]));
        return table.Append(Row("all", [.. Counted(outcomes)])).ToString();
    }

    /// <summary>The survivors, one a row, by file and in the order of the text.</summary>
    public static string Survivors(IReadOnlyCollection<Outcome> outcomes, Reasons reasons)
    {
        StringBuilder page = new();
        foreach (IGrouping<string, Outcome> file in Counted(outcomes).Where(outcome => !IsKilled(outcome)).GroupBy(outcome => outcome.Mutant.File))
        {
            page.Append($"\n### {file.Key}\n\n| line | change | why it survives |\n| --- | --- | --- |\n");
            foreach (Outcome outcome in file)
                page.Append($"| {Code(outcome.Mutant.Line)} | {Code(outcome.Mutant.Change)} | {reasons.For(outcome.Mutant) ?? "**no reason given yet**"}{(outcome.Fate == Fate.KilledByGolden ? " (the golden hash notices)" : "")} |\n");
        }

        return page.ToString();
    }

    private static List<Outcome> Counted(IEnumerable<Outcome> outcomes) => [.. outcomes.Where(outcome => outcome.Fate != Fate.NotOne)];

    private static bool IsKilled(Outcome outcome) => outcome.Fate is Fate.Killed or Fate.TimedOut;

    private static double Share(List<Outcome> outcomes, Func<Outcome, bool> counts) => outcomes.Count == 0 ? 1 : (double)outcomes.Count(counts) / outcomes.Count;

    private static string Row(string name, List<Outcome> outcomes) =>
        $"| {name} | {outcomes.Count} | {outcomes.Count(IsKilled)} | {outcomes.Count(outcome => outcome.Fate == Fate.TimedOut)} " +
        $"| {Share(outcomes, IsKilled):P1} | {Share(outcomes, outcome => IsKilled(outcome) || outcome.Fate == Fate.KilledByGolden):P1} |\n";

    private static string Code(string text) => "`" + text.Replace("|", "\\|", StringComparison.Ordinal) + "`";
}
