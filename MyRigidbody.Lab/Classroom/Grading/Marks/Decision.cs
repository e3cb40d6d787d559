using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading.Marks;

/// <summary>An instructor's decision about one submission.</summary>
/// <param name="File">Its file, by its name in <c>grade.json</c>.</param>
/// <param name="Content">A hash of the script that was inspected; null for any script with this name.</param>
/// <param name="Steps">Steps that are right, or are not.</param>
/// <param name="Use">Which of several scripts counts; null where there is no choice.</param>
/// <param name="Student">The student; null where that is known.</param>
/// <param name="Counts">False for one of two submissions that does not count.</param>
/// <param name="Points">The points, independent of the steps; null to compute them.</param>
/// <param name="Note">A note to the student, shown on the page.</param>
internal sealed record Decision(
    string File,
    string? Content,
    IReadOnlyDictionary<Step, bool> Steps,
    string? Use,
    Student? Student,
    bool? Counts,
    double? Points,
    string Note)
{
    /// <summary>The judgement with the decision applied.</summary>
    public Judgement Settle(Judgement judgement)
    {
        if (Use != null && judgement.Candidates.FirstOrDefault(one => one.File == Use || one.File!.EndsWith("!" + Use, StringComparison.Ordinal) || one.File.EndsWith("/" + Use, StringComparison.Ordinal)) is Judgement chosen)
            judgement = chosen;

        if (Steps.Count == 0)
            return judgement;

        Verdict verdict = judgement.Verdict;
        Dictionary<Step, Mark> marks = Verdict.FiveSteps.ToDictionary(
            step => step, step => Steps.TryGetValue(step, out bool right) ? right ? Mark.Right : Mark.Wrong : verdict[step]);
        IEnumerable<Finding> findings = verdict.Findings.Where(finding => Steps.GetValueOrDefault(finding.Step) is false)
            .Select(finding => Steps.ContainsKey(finding.Step) ? Firm(finding) : finding);
        return judgement with { Verdict = new Verdict(marks, findings), Candidates = [] };
    }

    private static Finding Firm(Finding doubtful)
    {
        Finding firm = new(doubtful.Step, doubtful.Code, doubtful.Expected, doubtful.Found, doubtful.English, doubtful.Chinese);
        firm = doubtful.Line is int line ? firm.At(line) : firm;
        return doubtful.Since is int frame ? firm.From(doubtful.Experiment, frame) : firm;
    }
}
