using System.CommandLine;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Pages;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Judges the submissions of a class.</summary>
internal static class GradeCommand
{
    private static readonly string DefaultFolder = Path.Combine(CompareCommand.DefaultFolder, "grade");

    public static Command Create()
    {
        Argument<string[]> paths = new("PATH") { Description = "scripts, .unitypackage, .zip, and folders of them", Arity = ArgumentArity.OneOrMore };
        Option<string> output = new("--out") { Description = "where the pages and tables go", HelpName = "DIR", DefaultValueFactory = _ => DefaultFolder };
        Option<string?> roster = new("--roster") { Description = "the class list, a CSV with 学号 and 姓名 (id, name): says who is missing", HelpName = "FILE.csv" };
        Option<string?> starter = new("--starter") { Description = "the MyRigidbody.cs that was handed out, if not the sheet's", HelpName = "FILE.cs" };
        Option<string?> marks = new("--marks") { Description = "points, and what you have settled of cases in doubt", HelpName = "FILE.json" };
        Command command = new("grade", "Judges the lab's scripts of a class: a page for the class, one for each student, marks") { paths, output, roster, starter, marks };
        command.SetAction(parsed => Execute(
            parsed.GetValue(paths)!, parsed.GetValue(output)!, parsed.GetValue(roster), parsed.GetValue(starter), parsed.GetValue(marks)));
        return command;
    }

    private static int Execute(string[] paths, string output, string? rosterFile, string? starterFile, string? marksFile)
    {
        if (paths.Contains(string.Empty))
            throw new InputException("PATH: must not be empty");

        Roster? roster = rosterFile == null ? null : Roster.Read(rosterFile);
        MarksFile marks = marksFile == null ? MarksFile.Default : MarksFile.Read(marksFile);
        string? starter = starterFile == null ? null : Starter(starterFile);
        using ClassFiles files = new(output, [.. paths.Where(File.Exists).Concat(new[] { rosterFile, starterFile, marksFile }.OfType<string>())]);
        Class all = null!;
        Terminal.WithProgress("grade " + paths[0], report => all = new Grader(new ScriptBench(starter)).Judge(paths, output, roster, marks, report));
        files.Write(all);
        Print(all, output);
        return 0;
    }

    private static string Starter(string path)
    {
        string text = SourceText.Decode([.. InputFile.Bytes(path)]).Text;
        return text.Contains("MonoBehaviour", StringComparison.Ordinal) ? text : throw new InputException($"{path}: is no script of Unity: there is no MonoBehaviour in it");
    }

    private static void Print(Class all, string output)
    {
        TextTable table = new TextTable(["student", .. Verdict.FiveSteps.Select(MarksFile.NameOf), "comments", "points", "verdict"]).RightAligned(6, 7);
        foreach (Graded one in all.Submissions)
        {
            table.AddRow([
                StudentPage.Title(one),
                .. Verdict.FiveSteps.Select(step => MarksFile.NameOf(one.Judgement.Verdict[step])),
                $"{one.Judgement.Commented}/{one.Judgement.Statements}",
                StudentPage.Number(one.Marked.Total),
                MarksFile.NameOf(one.Judgement.Verdict.Outcome)]);
        }

        Terminal.Write(table);
        int open = Question.Of(all).Count;
        if (open > 0)
            Terminal.WriteLine($"needs you: {open}, first on the page of the class");

        if (all.Missing.Count > 0)
            Terminal.WriteLine($"nothing handed in: {string.Join(", ", all.Missing.Select(student => $"{student.Id} {student.Name}".Trim()))}");

        foreach ((string place, Finding finding) in all.Passed)
            Terminal.Note($"{place}: {(Language.IsChinese ? finding.Chinese : finding.English)}");

        foreach (string file in all.Unused)
            Terminal.Note($"--marks: there is no submission {file}");

        Terminal.WriteLine("written: " + Path.Combine(output, "index.html"));
    }
}
