using System.CommandLine;
using RigidBodyDynamics.Lab.Animation;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>MyRigidbody beside DefaultRigidbody: the motions, how far they are apart, and the share of each rule in that.</summary>
internal static class CompareCommand
{
    /// <summary>The default folder for results.</summary>
    public const string DefaultFolder = "out";

    /// <summary>The default limit for the difference between a recording and the simulation, m, rad and their rates.</summary>
    public const double DefaultTolerance = 1e-3;

    private const long MostSteps = 5_000_000;

    // four pictures each, and some twenty bodies that are stepped
    private const int MostPairs = 100;

    // measured: memory for each step while the motion at a frame rate is summed, bytes
    private const double BytesOfStep = 150;

    public static Command Create()
    {
        Argument<string?> scene = new("SCENE")
        {
            Description = "a scene file or a recording; the lab's scene if absent",
            Arity = ArgumentArity.ZeroOrOne,
        };
        Option<string> output = new("--out")
        {
            Description = "folder for trajectories, summary, pictures and report.html, a page to open in the browser",
            HelpName = "DIR",
            DefaultValueFactory = _ => DefaultFolder,
        };
        Option<double> tolerance = new("--tolerance")
        {
            Description = "for a recording: how far the simulation may be from it (m, rad, and both per s)",
            HelpName = "E",
            DefaultValueFactory = _ => DefaultTolerance,
            CustomParser = Numbers.Parse,
        };
        Command command = new("compare", "MyRigidbody beside DefaultRigidbody, and why they differ") { scene, output, tolerance };
        command.SetAction(parsed => Execute(parsed.GetValue(scene) ?? Gallery.Lab, parsed.GetValue(output)!, parsed.GetValue(tolerance)));
        return command;
    }

    /// <summary>Compares the bodies of a scene, or a recording with our own UnityRigidbody.</summary>
    public static int Execute(string path, string folder, double tolerance)
    {
        SceneFile file = SceneReader.Read(path).Told();
        if (file.Scene.Steps.Count > MostSteps)
            throw new InputException($"{path}: steps: compare takes at most {MostSteps}, found {file.Scene.Steps.Count}");

        return Breakdown.Placed(path, file.Scene, () => file.Recording != null
            ? RecordingComparison.Execute(file, file.Recording, folder, tolerance)
            : Pairs(file, folder));
    }

    private static int Pairs(SceneFile file, string folder)
    {
        SceneDescription scene = file.Scene;
        IReadOnlyList<Pair> pairs = Pair.Of(file);
        if (pairs.Count > MostPairs)
            throw new InputException($"{file.Path}: bodies: compare takes at most {MostPairs} pairs, found {pairs.Count}");

        Overrides.Named(file.Path, () => Memory.MustHold("steps", BytesOfStep * scene.Steps.Count));
        Simulation trajectory = Overrides.Start(file.Path, scene);
        List<Findings> found = [];
        Terminal.WithProgress("compare " + scene.Name, report =>
        {
            foreach (Pair pair in pairs)
                found.Add(Overrides.Named(file.Path, () => Findings.Of(pair, scene.Steps, done => report((found.Count + done) / pairs.Count))));
        });

        Pictures.NoteIfThereAreNoFonts();
        using Files files = new(folder, folder, file.Inputs);
        files.Write("trajectory.csv", to => TrajectoryCsv.Write(trajectory, file.Path, to));
        files.Write("apart.csv", to => File.WriteAllText(to, CompareSummary.Csv(found)));
        files.Write("summary.json", to => File.WriteAllText(to, CompareSummary.Json(scene, found)));
        for (int i = 0; i < found.Count; i++)
        {
            Findings pair = found[i];
            string ending = found.Count > 1 ? "-" + (i + 1) : string.Empty;
            foreach (string format in new[] { ".png", ".svg" })
            {
                files.Write($"apart{ending}{format}", to => Pictures.Save(ComparePictures.Apart($"{scene.Name}: how far {pair.Pair.Mine.Name} and {pair.Pair.Default.Name} part", pair.Course), to));
                files.Write($"rules{ending}{format}", to => Pictures.Save(ComparePictures.Rules(scene, pair), to));
            }
        }

        Motion motion = Motion.Of(file, found);
        MotionPictures.Write(scene.Name, motion, files);
        files.Write(Reports.FileName, to => PageWriter.Write(Reports.Of(file, trajectory, found, motion), to));
        files.Keep();
        Print(scene, found, folder);
        return 0;
    }

    private static void Print(SceneDescription scene, List<Findings> found, string folder)
    {
        double duration = scene.Steps.StartOf(scene.Steps.Count);
        Terminal.WriteText(FormattableString.Invariant($"{scene.Name}: {scene.About}"));
        Terminal.WriteText(FormattableString.Invariant($"{scene.Steps.Count} steps, {duration:0.###} s"));
        foreach (Findings pair in found)
        {
            Terminal.WriteLine();
            CompareTables.Print(pair);
        }

        Terminal.WriteLine();
        Terminal.WriteText($"Written to {folder}: trajectory.csv, apart.csv, summary.json, pictures (.png, .svg), replay.png, which moves, and {Reports.FileName}, to open in the browser");
    }
}
