using System.Globalization;
using System.Text;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;

namespace RigidBodyDynamics.Lab.Grading.Export;

/// <summary>The marks as rows: one for each student, including those without a submission. A cell is a text or a number.</summary>
internal static class MarksTable
{
    public static readonly IReadOnlyList<string> Headings =
    [
        "学号 id", "姓名 name", "分数 points", "1 速度 velocity", "2 角速度 angular velocity", "3 位置 position", "4 朝向 orientation", "5 阻尼 damping",
        "注释 commented", "语句 statements", "扣分 taken off", "结论 verdict", "待定 to settle", "说明 about", "文件 file",
    ];

    public static IReadOnlyList<object[]> Rows(Class all) =>
    [
        .. all.Submissions.Where(one => one.Counts).Select(Row),
        .. all.Missing.Select(student => new object[]
        {
            student.Id, student.Name, string.Empty, string.Empty, string.Empty, string.Empty, string.Empty, string.Empty, string.Empty, string.Empty, string.Empty,
            "not handed in 未提交", string.Empty, string.Empty, string.Empty,
        }),
    ];

    /// <summary>As CSV with a byte order mark, by which spreadsheets recognise UTF-8.</summary>
    public static byte[] Csv(Class all)
    {
        StringBuilder text = new();
        foreach (object[] row in Rows(all).Prepend([.. Headings]))
            text.AppendJoin(',', row.Select(cell => cell is double number ? number.ToString(CultureInfo.InvariantCulture) : Output.Csv.Cell((string)cell))).Append("\r\n");

        return [.. Encoding.UTF8.Preamble, .. Encoding.UTF8.GetBytes(text.ToString())];
    }

    private static object[] Row(Graded one) =>
    [
        one.Student?.Id ?? string.Empty,
        one.Student?.Name ?? string.Empty,
        one.Marked.Total,
        .. Verdict.FiveSteps.Select(step => MarksFile.NameOf(one.Judgement.Verdict[step])),
        (double)one.Judgement.Commented,
        (double)one.Judgement.Statements,
        one.Marked.Comments + one.Marked.Name + one.Marked.Given,
        MarksFile.NameOf(one.Judgement.Verdict.Outcome),
        string.Join(' ', one.Judgement.Verdict.Findings.Where(finding => finding.IsDoubtful).Select(finding => finding.Code).Distinct()),
        string.Join("；", one.Judgement.Verdict.Findings.Select(finding => finding.Chinese).Distinct()),
        one.File,
    ];
}
