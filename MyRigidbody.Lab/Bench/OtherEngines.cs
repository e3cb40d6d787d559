using System.Globalization;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>
/// A thousand bodies that rotate freely, by our integrators and by the engines that npm has as WebAssembly or JavaScript.
/// Node runs those (tests/engines), in a process of its own and after our times were taken.
/// </summary>
/// <param name="Rows">Ours, then the others; empty if there is a problem.</param>
/// <param name="Problem">Why there are none, in one line; empty if there are.</param>
internal sealed record OtherEngines(IReadOnlyList<OtherEngines.Row> Rows, string Problem)
{
    /// <summary>The number of bodies in the world in which each is timed.</summary>
    public const int Bodies = 1000;

    private const string Folder = "tests/engines";
    private const double Step = 0.02, Until = 100;
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(300);

    // the names of Suite.Many
    private static readonly (string Shown, string What, string Rule)[] Ours =
    [
        ("MyRigidbody, LabEuler, one by one", "LabEuler, one by one", "LabEuler"),
        ("MyRigidbody, LabEuler, together", "LabEuler, together", "LabEuler"),
        ("MyRigidbody, Exact, one by one", "Exact, three moments, one by one", "Exact"),
        ("MyRigidbody, Exact, together", "Exact, three moments, together", "Exact"),
    ];

    /// <summary>Measures, if Node is on the PATH and the engines were installed.</summary>
    /// <param name="ours">Our times.</param>
    /// <param name="repeats">The number of repeats.</param>
    public static OtherEngines Take(IEnumerable<Measurement> ours, int repeats)
    {
        if (OtherProgram.OnPath("node") is not string node)
            return Without("there is no node on the PATH");

        string folder = Path.Combine(Checkout.Find() ?? string.Empty, Folder);
        if (!Directory.Exists(Path.Combine(folder, "node_modules")))
            return Without($"they are not installed; npm install --prefix {Folder} does that");

        CostMotion motion = SolvedMotion.Read(OtherEngine.Motion, Until);
        Quaterniond q = motion.Truth.Samples[^1].Bodies[0].Orientation;
        string[] arguments = [Path.Combine(folder, "measure.mjs"), .. new[] { repeats, q.W, q.X, q.Y, q.Z }.Select(number => number.ToString("R", CultureInfo.InvariantCulture))];
        OtherProgram others = OtherProgram.Run(node, arguments, new Dictionary<string, string>(), Patience);
        if (others.Problem.Length > 0)
            return Without(others.Problem);

        IEnumerable<Row> measured = from name in Ours
                                    from measurement in ours
                                    where measurement.What == name.What && measurement.Bodies == Bodies && measurement.Threads == 1
                                    select new Row(name.Shown, measurement.Median, Error(motion, name.Rule));
        return Of(measured, others.Output);
    }

    /// <summary>Our rows, and those for which the other program printed a time and an error.</summary>
    public static OtherEngines Of(IEnumerable<Row> ours, string others)
    {
        List<Row> theirs = [.. others.Split('\n').Select(line => line.Split(',')).Where(cells => cells.Length == 3)
            .Select(cells => new Row(cells[0], Number(cells[1]), Number(cells[2])))
            .Where(row => row.Nanoseconds > 0 && double.IsFinite(row.Nanoseconds) && row.AngleError >= 0)];
        return theirs.Count > 0 ? new OtherEngines([.. ours, .. theirs], string.Empty) : Without("the other program printed no times");
    }

    /// <summary>The table for the terminal.</summary>
    public TextTable Table()
    {
        TextTable table = new("A thousand free bodies, beside other engines", "ns a step", "error within 100 s, rad");
        foreach (Row row in Rows)
            table.AddRow(row.Engine, CostTables.Number(row.Nanoseconds), CostTables.Error(row.AngleError));

        return table;
    }

    /// <summary>A file of its own: engine, time of a step of one body, and error of its orientation.</summary>
    public string Csv() => "engine,nanosecondsPerBodyStep,angleError\n"
        + string.Concat(Rows.Select(row => string.Create(CultureInfo.InvariantCulture, $"\"{row.Engine}\",{row.Nanoseconds:R},{row.AngleError:R}\n")));

    private static double Error(CostMotion motion, string rule)
    {
        // the largest error of a run, because one at the end may be small by chance
        Simulation simulation = new(StepFree.By(motion.Scene, Rules.Named(rule), TimeSteps.Every(Step)));
        double worst = 0;
        foreach (TruthSample sample in motion.Truth.Samples)
        {
            simulation.Step((long)Math.Round(sample.At * motion.Truth.BaseStep / Step) - simulation.StepsDone);
            worst = Math.Max(worst, Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, sample.Bodies[0].Orientation));
        }

        return worst;
    }

    private static double Number(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN;

    private static OtherEngines Without(string problem) => new([], problem);

    /// <summary>An engine.</summary>
    /// <param name="Engine">Its name and version, or our integrator.</param>
    /// <param name="Nanoseconds">For a step of one body in a world of <see cref="Bodies"/>.</param>
    /// <param name="AngleError">Error of the orientation of one body, rad, with steps of 1/50 s: for our integrators the largest within 100 s, for an engine that after 100 s.</param>
    internal sealed record Row(string Engine, double Nanoseconds, double AngleError);
}
