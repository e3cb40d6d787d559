using System.CommandLine;
using System.Globalization;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Writes the trajectory of a scene.</summary>
internal static class RunCommand
{
    private const long StepsAtFirst = 50_000, MillisecondsOfPiece = 50;

    // a run that would take more than a year, estimated after its first second, has a wrong step length
    private const double MillisecondsTillEstimate = 1000, MostMilliseconds = 3.15e10;

    // often enough for a reader that waits, and to notice one that has closed the pipe
    private const long MillisecondsBetweenFlushes = 200;

    public static Command Create()
    {
        Argument<string> scene = new("SCENE") { Description = "a scene file or a recording" };
        Option<string?> integrator = new("--integrator") { Description = "the integrator for every body, instead of the file's", HelpName = "NAME" };
        Option<double?> step = new("--step")
        {
            Description = "length of every step in s, instead of the file's",
            HelpName = "S",
            CustomParser = result => Numbers.Parse(result),
        };
        Option<long> every = new("--every")
        {
            Description = "write every K-th step; 0: the end only",
            HelpName = "K",
            DefaultValueFactory = _ => 1,
        };
        Option<string?> output = new("--out") { Description = "the file to write; standard output if absent", HelpName = "FILE" };
        Option<string?> report = new("--report") { Description = "also a page to open in the browser; the scene runs once more for it", HelpName = "FILE" };
        Command command = new("run", "The trajectory of a scene, as CSV") { scene, integrator, step, every, output, report };
        command.SetAction(parsed => Execute(
            parsed.GetValue(scene)!,
            parsed.GetValue(integrator),
            parsed.GetValue(step),
            parsed.GetValue(every),
            parsed.GetValue(output),
            parsed.GetValue(report)));
        return command;
    }

    private static int Execute(string path, string? integrator, double? step, long every, string? output, string? report)
    {
        if (every < 0)
            throw new InputException($"--every: must not be below 0, found {every}");

        if (output?.Length > 0 && report?.Length > 0 && RealPath.Same(output, report))
            throw new InputException($"--report: must be another file than --out, found {report}");

        SceneFile read = SceneReader.ReadWithCrowds(path).Told();
        SceneDescription scene = Overrides.Apply(read.Scene, integrator, step);
        if (output == null)
        {
            using Stream standard = StandardOutput.Open();
            Breakdown.Placed(path, scene, () => Write(Bodies(), every, path, standard));
        }
        else
        {
            WriteFile("--out", output, read, temporary =>
            {
                using FileStream file = new(temporary, FileMode.Create);
                Breakdown.Placed(path, scene, () => Write(Bodies(), every, path, file));
            });
        }

        if (report != null)
        {
            string command = Command(path, integrator, step, report);
            WriteFile("--report", report, read, temporary => PageWriter.Write(Breakdown.Placed(path, scene, () => Reports.Of(read, scene, Bodies(), command)), temporary));
        }

        return 0;

        Simulation Bodies() => Overrides.Named(path, () => ManyBodies.Simulate(scene, read.Crowds));
    }

    private static string Command(string path, string? integrator, double? step, string report)
    {
        List<string> parts = ["run", Page.Shown(path)];
        parts.AddRange(integrator != null ? ["--integrator", integrator] : []);
        parts.AddRange(step != null ? ["--step", step.Value.ToString("R", CultureInfo.InvariantCulture)] : []);
        return Shell.Line([.. parts, "--report", Page.Shown(report)]);
    }

    private static void WriteFile(string option, string file, SceneFile read, Action<string> write)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(file.Length > 0 ? file : throw new InputException($"{option}: must not be empty"))) ?? throw new InputException($"{file}: is a folder");
        using Files files = new(folder, file, read.Inputs);
        files.Write(Path.GetFileName(file), write);
        files.Keep();
    }

    private static void Write(Simulation simulation, long every, string path, Stream stream)
    {
        using TrajectoryCsv csv = new(stream);
        csv.WriteHeader();
        long count = simulation.Scene.Steps.Count;
        if (every > 0)
        {
            RunAway.MustBeFinite(simulation, path);
            csv.WriteRows(simulation);
        }

        Terminal.WithProgress("run " + path, report =>
        {
            long started = Environment.TickCount64, flushed = started;
            long next = every == 0 ? count : Math.Min(every, count), piece = StepsAtFirst;
            while (simulation.StepsDone < count)
            {
                long began = Environment.TickCount64;
                simulation.Step(Math.Min(next - simulation.StepsDone, piece));
                // coasting bodies take 2⁶³ steps as fast as one
                piece = Environment.TickCount64 - began < MillisecondsOfPiece ? Math.Min(piece, long.MaxValue / 2) * 2 : Math.Max(piece / 2, StepsAtFirst);
                report((double)simulation.StepsDone / count);
                MustEnd(path, Environment.TickCount64 - started, simulation.StepsDone, count);
                if (simulation.StepsDone == next)
                {
                    RunAway.MustBeFinite(simulation, path);
                    csv.WriteRows(simulation);
                    next = every == 0 || next > count - every ? count : next + every;
                }

                if (Environment.TickCount64 - flushed > MillisecondsBetweenFlushes)
                {
                    csv.Flush();
                    flushed = Environment.TickCount64;
                }
            }
        });
    }

    private static void MustEnd(string path, double milliseconds, long done, long count)
    {
        double all = milliseconds * count / done;
        if (milliseconds > MillisecondsTillEstimate && all > MostMilliseconds)
            throw new InputException(FormattableString.Invariant($"{path}: steps: {count} of them would take {all / MostMilliseconds:g2} years here"));
    }

    /// <summary>Writes a row only if all of it is finite: states are, but their energy may overflow for a large mass.</summary>
}
