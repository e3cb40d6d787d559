using System.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>Figures and survivors, as a page and as lines.</summary>
internal static class Report
{
    /// <summary>Of the mutants that are not the same as the original, the share that tests other than the golden one notice.</summary>
    public static double Share(IEnumerable<Outcome> outcomes, Reasons reasons)
    {
        List<Outcome> others = [.. Counted(outcomes).Where(outcome => IsKilled(outcome) || !reasons.IsSame(outcome.Mutant))];
        return Share(others.Count(IsKilled), others.Count);
    }

    /// <summary>What became of the mutants of each folder.</summary>
    public static string Figures(IReadOnlyCollection<Outcome> outcomes, Reasons reasons)
    {
        StringBuilder table = new(
            """
            | folder | mutants | killed | of these by a time limit | survive, the same as the original | survive | killed | killed, with the golden hash | killed of those not the same |
            | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |

            """);
        foreach (IGrouping<string, Outcome> folder in Counted(outcomes).GroupBy(outcome => outcome.Mutant.Folder).OrderBy(group => group.Key, StringComparer.Ordinal))
            table.Append(Row(folder.Key, [.. folder], reasons));
        return table.Append(Row("all", Counted(outcomes), reasons)).ToString();
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

    private static double Share(int count, int all) => all == 0 ? 1 : (double)count / all;

    private static string Row(string name, List<Outcome> outcomes, Reasons reasons)
    {
        int killed = outcomes.Count(IsKilled), golden = outcomes.Count(outcome => outcome.Fate == Fate.KilledByGolden);
        int same = outcomes.Count(outcome => !IsKilled(outcome) && reasons.IsSame(outcome.Mutant));
        return $"| {name} | {outcomes.Count} | {killed} | {outcomes.Count(outcome => outcome.Fate == Fate.TimedOut)} | {same} | {outcomes.Count - killed - same} " +
            $"| {Share(killed, outcomes.Count):P1} | {Share(killed + golden, outcomes.Count):P1} | {Share(outcomes, reasons):P1} |\n";
    }

    private static string Code(string text) => "`" + text.Replace("|", "\\|", StringComparison.Ordinal) + "`";
}
