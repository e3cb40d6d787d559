using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading.Export;

/// <summary>All results, for other programs: the format <c>rigid-body-grade/1</c>.</summary>
internal static class GradeJson
{
    private static readonly JsonSerializerOptions Options = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        // letters of all languages as they are; characters special in HTML are escaped, because the text may be put into a page
        Encoder = JavaScriptEncoder.Create(System.Text.Unicode.UnicodeRanges.All),
        Converters = { new JsonStringEnumConverter(JsonNamingPolicy.CamelCase) },
    };

    public static string Of(Class all) => Visible.Json(JsonSerializer.Serialize(
        new
        {
            schema = "rigid-body-grade/1",
            submissions = all.Submissions.Select(Submission),
            missing = all.Roster == null ? null : all.Missing.Select(student => new { student.Id, student.Name }),
            passed = all.Passed.Select(note => new { file = note.Place, code = note.Finding.Code, en = note.Finding.English, zh = note.Finding.Chinese }),
        },
        Options)) + "\n";

    private static object Submission(Graded one) => new
    {
        one.File,
        one.Content,
        student = one.Student is { } student ? new { student.Id, student.Name } : null,
        one.Submission.NameAsAsked,
        verdict = one.Judgement.Verdict.Outcome,
        steps = Verdict.FiveSteps.ToDictionary(MarksFile.NameOf, step => one.Judgement.Verdict[step]),
        given = one.Judgement.Verdict.GivenChanged ? "changed" : "right",
        findings = one.Judgement.Verdict.Findings.Concat(one.Submission.Notes).Select(Finding),
        comments = new { one.Judgement.Statements, one.Judgement.Commented, one.Judgement.Uncommented },
        alike = one.Alike.Select(other => new { other.File, share = Math.Round(other.Share, 3) }),
        points = one.Marked.Total,
        one.Counts,
        settled = one.Decision != null,
    };

    private static object Finding(Finding finding) => new
    {
        finding.Step,
        finding.Code,
        doubtful = finding.IsDoubtful,
        finding.Line,
        finding.Since,
        finding.Experiment,
        finding.Expected,
        finding.Found,
        en = finding.English,
        zh = finding.Chinese,
    };
}
