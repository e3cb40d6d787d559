using System.CommandLine;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Accuracy against time for every integrator.</summary>
internal static class CostCommand
{
    private static readonly string[] QuickMotions = ["asym_moderate", "world_torque"];

    public static Command Create()
    {
        Argument<string[]> scenes = new("SCENE")
        {
            Description = "scene files; ten motions solved to 20 digits and the lab's scene if absent",
            Arity = ArgumentArity.ZeroOrMore,
        };
        Option<string> output = new("--out")
        {
            Description = "folder for cost.csv and a diagram of every motion",
            HelpName = "DIR",
            DefaultValueFactory = _ => CompareCommand.DefaultFolder,
        };
        Option<bool> quick = new("--quick") { Description = "fewer motions and steps, less certain times: some seconds instead of minutes" };
        Command command = new("cost", "Accuracy against time for every integrator, measured on this machine") { scenes, output, quick };
        command.SetAction(parsed => Execute(parsed.GetValue(scenes) ?? [], parsed.GetValue(output)!, parsed.GetValue(quick)));
        return command;
    }

    private static int Execute(string[] paths, string folder, bool quick)
    {
        // bad input is refused before a measurement of minutes
        foreach (string path in paths)
            Overrides.Named(path, () => StepFree.Of(SceneReader.Read(path).Told().Scene));

        List<Func<Action<double>, CostMotion>> motions = [.. (paths.Length > 0 ? paths : [Gallery.Lab])
            .Select(path => (Func<Action<double>, CostMotion>)(report => CostMotion.Of(path, report)))];
        if (paths.Length == 0)
        {
            motions.InsertRange(0, SolvedMotion.All.Where(motion => !quick || QuickMotions.Contains(motion.Name))
                .Select(motion => (Func<Action<double>, CostMotion>)(_ => SolvedMotion.Read(motion.Name, motion.Until))));
        }

        using Files files = new(folder, folder, paths);
        Pictures.NoteIfThereAreNoFonts();
        List<CostFindings> found = [];
        Terminal.WithProgress("cost", report =>
        {
            foreach (Func<Action<double>, CostMotion> motion in motions)
            {
                CostMotion read = motion(done => report((found.Count + (0.3 * done)) / motions.Count));
                found.Add(CostFindings.Of(read, quick ? Effort.Quick : Effort.Whole, done => report((found.Count + 0.3 + (0.7 * done)) / motions.Count)));
            }
        });
        Write(found, files, Shell.Line(["cost", .. paths.Select(Report.Page.Shown), .. quick ? ["--quick"] : Array.Empty<string>()]));
        Print(found, folder);
        return 0;
    }

    private static void Write(List<CostFindings> found, Files files, string command)
    {
        files.Write("cost.csv", to => File.WriteAllText(to, CostCsv.Of(found)));
        HashSet<string> taken = [];
        foreach (CostFindings findings in found)
        {
            string name = FileName(findings.Motion.Scene.Name, taken);
            foreach (string format in new[] { ".png", ".svg" })
                files.Write(name + format, to => Pictures.Save(CostPictures.Of(findings), to, CostPictures.Height));
        }

        files.Write("cost.html", to => PageWriter.Write(Reports.Of(found, command), to));
        files.Keep();
    }

    /// <summary>A file name that every system accepts; names of scenes may repeat, and contain anything.</summary>
    private static string FileName(string scene, HashSet<string> taken)
    {
        string plain = string.Concat(scene.Take(60).Select(letter => char.IsLetterOrDigit(letter) || letter is '-' or '_' ? letter : '-'));
        string name = "cost-" + plain;
        for (int i = 2; !taken.Add(name.ToUpperInvariant()); i++)
            name = FormattableString.Invariant($"cost-{plain}-{i}");

        return name;
    }

    private static void Print(List<CostFindings> found, string folder)
    {
        foreach (CostFindings findings in found)
        {
            CostTables.Print(findings);
            Terminal.WriteLine();
        }

        Terminal.WriteText(CostTables.Legend);
        Terminal.WriteLine();
        Terminal.WriteText("The cheapest integrator with an error below each bound, and its cost per simulated second:");
        foreach (CostFindings findings in found)
            Terminal.WriteText("- " + CostTables.InWords(findings));

        Terminal.WriteLine();
        Terminal.WriteText($"Written to {folder}: cost.csv, a diagram of every motion (.png, .svg), and cost.html, to open in the browser");
    }
}
