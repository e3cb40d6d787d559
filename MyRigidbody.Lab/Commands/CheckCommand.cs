using System.CommandLine;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Tells a student which of the five steps of a script is wrong, without Unity.</summary>
internal static class CheckCommand
{
    public static Command Create()
    {
        Argument<string> script = new("SCRIPT") { Description = "the script, MyRigidbody.cs; what it names in files beside it is compiled along" };
        Option<string?> output = new("--out") { Description = "folder for report.html: the findings, and the script moving beside the reference and Unity's body", HelpName = "DIR" };
        Option<bool> json = new("--json") { Description = "as JSON, in both languages" };
        Option<bool> watch = new("--watch") { Description = "again whenever the file is saved, until Ctrl-C" };
        Command command = new("check", "Which of the lab's five steps a script has right, and what is wrong in the others") { script, output, json, watch };
        command.SetAction(parsed => Execute(
            parsed.GetValue(script)!,
            parsed.GetValue(output),
            Language.IsChinese,
            parsed.GetValue(json),
            parsed.GetValue(watch)));
        return command;
    }

    private static int Execute(string path, string? folder, bool isChinese, bool asJson, bool watches)
    {
        using Checker checker = new();
        int code = Once(checker, path, folder, isChinese, asJson);
        if (!watches)
            return code;

        foreach (bool _ in Saves.Of(path))
        {
            if (!asJson)
                Terminal.WriteLine($"── {DateTime.Now:HH:mm:ss} ──");

            try
            {
                Once(checker, path, folder, isChinese, asJson);
            }
            catch (InputException gone)
            {
                // an editor may have deleted the old file and not yet written the new one
                Terminal.Note(gone.Message);
            }
        }

        return code;
    }

    private static int Once(Checker checker, string path, string? folder, bool isChinese, bool asJson)
    {
        ScriptReport report = checker.Check(path);
        Finding? noScript = report.Verdict.Findings.FirstOrDefault(finding => finding.Code is "no-script" or "too-large");
        if (noScript != null && !asJson)
            throw new InputException($"{path}: {(isChinese ? noScript.Chinese : noScript.English)}");

        if (folder != null)
        {
            using Files files = new(folder, folder, [path]);
            files.Write(Reports.FileName, to => PageWriter.Write(CheckPage.Of(path, report), to));
            files.Keep();
        }

        if (asJson)
            Terminal.WriteJson(CheckJson.Of(path, report));
        else
            Lamps.Print(path, report, isChinese);

        if (folder != null && !asJson)
            Terminal.WriteLine(CheckWords.All["written"].With(folder, Reports.FileName).In(isChinese));

        return report.Verdict.Outcome == Outcome.Right ? 0 : noScript != null ? 2 : 1;
    }
}
