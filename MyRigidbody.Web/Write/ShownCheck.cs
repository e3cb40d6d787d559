using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Web.Write;

/// <summary>The page of check as data for the lamps beside the editor: its words in both languages, and the lines.</summary>
internal static class ShownCheck
{
    /// <summary>Lamps in the order of the steps, then the findings.</summary>
    public static object Of(ScriptReport report)
    {
        CheckPage.Findings shown = new(report);
        return new
        {
            outcome = Said(shown.Outcome),
            kind = Key(report.Verdict.Outcome),
            lamps = Verdict.FiveSteps.Zip(shown.Lamps, (step, lamp) => new
            {
                key = Key(step),
                step = Said(lamp.Step),
                formula = lamp.Formula,
                result = Said(lamp.Result),
                kind = lamp.Kind,
                line = report.Lines.TryGetValue(step, out int line) ? line : (int?)null,
            }),
            notes = report.Verdict.Findings.Zip(shown.Notes, (finding, note) => new
            {
                key = Key(finding.Step),
                step = Said(note.Step),
                code = finding.Code,
                line = finding.Line,
                place = Said(note.Place),
                help = Said(note.Help),
                measured = Said(note.Measured),
                doubtful = finding.IsDoubtful,
            }),
            comments = Said(shown.Comments),
            bare = report.Comments.Bare.Distinct(),
        };
    }

    private static object Said(Word word) => new { en = word.En, zh = word.Zh };

    private static string Key(Enum value) => System.Text.Json.JsonNamingPolicy.CamelCase.ConvertName(value.ToString());
}
