using System.Text.Json;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading.Export;

/// <summary>All results, for other programs: the format <c>rigid-body-grade/1</c>.</summary>
internal static class GradeJson
{
    public static string Of(Class all) => Visible.Json(JsonSerializer.Serialize(
        new
        {
            schema = "rigid-body-grade/1",
            submissions = all.Submissions.Select(Submission),
            missing = all.Roster == null ? null : all.Missing.Select(student => new { student.Id, student.Name }),
            passed = all.Passed.Select(note => new { file = note.Place, code = note.Finding.Code, en = note.Finding.English, zh = note.Finding.Chinese }),
        },
        CheckJson.Options)) + "\n";

    private static object Submission(Graded one) => new
    {
        one.File,
        one.Content,
        student = one.Student is { } student ? new { student.Id, student.Name } : null,
        one.Submission.NameAsAsked,
        verdict = one.Judgement.Verdict.Outcome,
        steps = Verdict.FiveSteps.ToDictionary(MarksFile.NameOf, step => one.Judgement.Verdict[step]),
        given = one.Judgement.Verdict.GivenChanged ? "changed" : "right",
        findings = one.Judgement.Verdict.Findings.Concat(one.Submission.Notes).Select(CheckJson.Of),
        comments = new { one.Judgement.Statements, one.Judgement.Commented, one.Judgement.Uncommented },
        alike = one.Alike.Select(other => new { other.File, share = Math.Round(other.Share, 3) }),
        points = one.Marked.Total,
        one.Counts,
        settled = one.Decision != null,
    };
}
