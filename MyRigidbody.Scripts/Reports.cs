using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Children;
using RigidBodyDynamics.StudentScripts.Comments;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>The report on a submission, from what the child has sent.</summary>
internal static class Reports
{
    public static ScriptReport Refused(Look? look, IReadOnlyList<ScriptFile> files, IReadOnlyList<Finding> why) =>
        Report(look, files, Refusal([.. why, .. look?.Notes ?? []], isDoubtful: why.All(finding => finding.IsDoubtful)), null);

    public static ScriptReport Judged(Look look, IReadOnlyList<ScriptFile> files, Recording recording)
    {
        IReadOnlyDictionary<Step, int> lines = StepLines.Of(look.Assignments);
        Verdict verdict = Judge.Decide(recording).Each(finding => finding.Line == null && lines.TryGetValue(finding.Step, out int line) ? finding.At(line) : finding);
        return Report(look, files, look.Notes.Aggregate(verdict, (sum, note) => sum.With(note)), recording);
    }

    // a limitation of the checker is not the script's fault
    private static Verdict Refusal(Finding[] findings, bool isDoubtful) =>
        isDoubtful ? new Verdict(new Dictionary<Step, Mark>(), findings) : Verdict.Refused(findings);

    private static ScriptReport Report(Look? look, IReadOnlyList<ScriptFile> files, Verdict verdict, Recording? recording)
    {
        ScriptFile? file = files.FirstOrDefault(known => known.Name == look?.File) ?? (files.Count == 1 ? files[0] : null);
        return new ScriptReport(
            verdict,
            look?.Comments ?? CommentCoverage.None,
            file?.Name,
            file == null ? string.Empty : SourceText.Decode(file.Bytes).Text,
            StepLines.Of(look?.Assignments ?? []),
            recording);
    }
}
