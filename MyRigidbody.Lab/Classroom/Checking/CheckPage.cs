using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>The page of check: the five lamps, the errors found, and the script's motion beside the reference and Unity's body.</summary>
internal static class CheckPage
{
    public static Page Of(string path, ScriptReport report)
    {
        string shown = Page.Shown(path);
        return new Page(
            Word.Name(Path.GetFileName(path)),
            string.Empty,
            shown,
            Shell.Line("check", shown),
            [
                new Findings(report),
                .. report.Recording is { } recording ? [new Replay(ScriptMotion.Of(recording))] : Array.Empty<Section>(),
                Facts.OfMachine(),
            ]);
    }

    /// <summary>The lamps, and below them the measurements.</summary>
    internal sealed record Findings(ScriptReport Report) : Section
    {
        /// <inheritdoc/>
        public override string Kind => "check";

        public Word Outcome => CheckWords.All["outcome." + Report.Verdict.Outcome];

        public IReadOnlyList<Lamp> Lamps =>
        [
            .. Verdict.FiveSteps.Select(step => new Lamp(
                CheckWords.Name(step),
                Terminology.Formula(step),
                CheckWords.Lamp(Report.Verdict[step]),
                Report.Verdict[step].ToString().ToLowerInvariant(),
                Report.Lines.TryGetValue(step, out int line) ? line.ToString(System.Globalization.CultureInfo.InvariantCulture) : string.Empty)),
        ];

        public IReadOnlyList<Note> Notes => [.. Report.Verdict.Findings.Select(finding => new Note(
            CheckWords.Name(finding.Step),
            CheckWords.Place(finding),
            new Word(finding.English, finding.Chinese),
            CheckWords.IsMeasured(finding) ? CheckWords.All["measured"].With(finding.Expected, finding.Found) : Word.Name(string.Empty),
            Source(finding.Line)))];

        public Word Comments => CheckWords.Comments(Report.Comments);

        public Word Step => CheckWords.All["step"];

        public Word Formula => CheckWords.All["formula"];

        public Word Result => CheckWords.All["lamp"];

        public Word Line => CheckWords.All["line"];

        private string Source(int? line) => line is { } at && Report.Text.Split('\n') is var lines && at <= lines.Length ? lines[at - 1].Trim() : string.Empty;
    }

    internal sealed record Lamp(Word Step, string Formula, Word Result, string Kind, string Line);

    /// <summary>One finding, with the line of the script.</summary>
    internal sealed record Note(Word Step, Word Place, Word Help, Word Measured, string Source);
}
