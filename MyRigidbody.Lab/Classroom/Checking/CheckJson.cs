using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.Unicode;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>One submission of the format <c>rigid-body-grade/1</c>.</summary>
internal static class CheckJson
{
    /// <summary>How the format is written: letters of all languages as they are; characters special in HTML are escaped, because the text may be put into a page.</summary>
    public static readonly JsonSerializerOptions Options = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        Encoder = JavaScriptEncoder.Create(UnicodeRanges.All),
        Converters = { new JsonStringEnumConverter(JsonNamingPolicy.CamelCase) },
    };

    public static string Of(string path, ScriptReport report)
    {
        // the submitted name: the file's own name or that of its folder
        string? name = new[] { Path.GetFileName(path), Path.GetFileName(Path.GetDirectoryName(Path.GetFullPath(path))) }.FirstOrDefault(part => part != null && StudentName.Read(part).Count > 0);
        Student? student = name == null ? null : StudentName.Read(name)[0];
        return JsonSerializer.Serialize(
            new
            {
                file = path.Replace('\\', '/'),
                student = student == null ? null : new { student.Id, student.Name },
                nameAsAsked = name != null && StudentName.IsAsAsked(name),
                verdict = report.Verdict.Outcome,
                steps = Verdict.FiveSteps.ToDictionary(step => JsonNamingPolicy.CamelCase.ConvertName(step.ToString()), step => report.Verdict[step]),
                given = report.Verdict.GivenChanged ? "changed" : "right",
                findings = report.Verdict.Findings.Select(Of),
                comments = new { report.Comments.Statements, report.Comments.Commented },
                alike = Array.Empty<object>(),
            },
            Options);
    }

    public static object Of(Finding finding) => new
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
