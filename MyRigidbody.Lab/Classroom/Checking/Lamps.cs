using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>The five lamps in the terminal, and the errors found.</summary>
internal static class Lamps
{
    public static void Print(string path, ScriptReport report, bool isChinese)
    {
        string Text(string key) => CheckWords.All[key].In(isChinese);

        TextTable table = new TextTable(new[] { "step", "formula", "lamp", "line" }.Select(Text)).RightAligned(3);
        foreach (Step step in Verdict.FiveSteps)
        {
            table.AddRow(
                CheckWords.Name(step).In(isChinese),
                Terminology.Formula(step),
                CheckWords.Lamp(report.Verdict[step]).In(isChinese),
                report.Lines.TryGetValue(step, out int line) ? line.ToString(System.Globalization.CultureInfo.InvariantCulture) : string.Empty);
        }

        Terminal.Write(table);
        Terminal.WriteText(Text("outcome." + report.Verdict.Outcome));
        foreach (Finding finding in report.Verdict.Findings)
        {
            Terminal.WriteLine();
            Terminal.WriteText(Heading(finding, isChinese));
            Terminal.WriteText("  " + (isChinese ? finding.Chinese : finding.English));
            if (CheckWords.IsMeasured(finding))
                Terminal.WriteText("  " + CheckWords.All["measured"].With(finding.Expected, finding.Found).In(isChinese));
        }

        Terminal.WriteLine();
        Terminal.WriteText(CheckWords.Comments(report.Comments).In(isChinese));
        Terminal.WriteText(CheckWords.FileName(path).In(isChinese));
    }

    private static string Heading(Finding finding, bool isChinese)
    {
        string place = CheckWords.Place(finding).In(isChinese);
        (string colon, string comma) = isChinese ? ("：", "，") : (": ", ", ");
        return $"{CheckWords.Name(finding.Step).In(isChinese)}{colon}{finding.Code}{(place.Length > 0 ? comma + place : string.Empty)}";
    }
}
