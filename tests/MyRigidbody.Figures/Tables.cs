using System.Globalization;

namespace RigidBodyDynamics.Figures;

/// <summary>The rows of the pages' tables of measurements.</summary>
internal static class Tables
{
    // the motion whose picture the README shows, and the scene of the lab
    private const string Free = "asym_moderate", Lab = "lab";

    private const double SameCost = 1.03;

    private static readonly double[] Bounds = [1e-3, 1e-6, 1e-9];

    // one of each kind among the motions of cost
    private static readonly string[] Kinds = [Free, "body_torque", "world_torque", "lagrange_top", "cube_sin_torque_damped", Lab];

    private static readonly string[] OnBoth = ["free body by LabEuler", "free body by Exact", "lab's step, by the library"];

    private static readonly (string English, string Chinese)[] Called =
    [
        ("MyRigidbody, ", "MyRigidbody，"), (", one by one", "，逐个计算"), (", together", "，合在一起计算"),
        ("free body by ", "自由刚体，"), ("lab's step, by the library", "实验的一步，用程序库"),
    ];

    /// <summary>The rows of a table by its name, as a page of the language has them; null if there is none of it.</summary>
    public static IReadOnlyList<string[]>? Of(string name, Measured measured, bool isChinese) =>
        isChinese ? Of(name, measured)?.Select(row => (string[])[InChinese(row[0]), .. row[1..]]).ToList() : Of(name, measured);

    /// <summary>The rows of a table by its name; null if there is none of it.</summary>
    public static IReadOnlyList<string[]>? Of(string name, Measured measured) => name switch
    {
        "integrators" => [.. Rules.All.Select(rule => Integrator(rule, measured))],
        "motions" => [.. Kinds.Select(kind => Motion(kind, measured))],
        "engines" => [.. measured.Engines.Select(line => (string[])[line["engine"], Time(Number(line["nanosecondsPerBodyStep"])), Error(Number(line["angleError"]))])],
        "runtimes" => [.. OnBoth.Select(what => (string[])[what, OneBody(what, measured), OneBody(what + ", on Mono", measured)])],
        _ => null,
    };

    /// <summary>What a row is called on a Chinese page.</summary>
    public static string InChinese(string name) => Called.Aggregate(name, (text, pair) => text.Replace(pair.English, pair.Chinese, StringComparison.Ordinal));

    private static string[] Integrator(Rule rule, Measured measured)
    {
        CostRow inGame = RowsOf(Free, measured).Single(row => row.Rule == rule.Name && row.Step == 0.02);
        IEnumerable<string> costs = Bounds.Select(bound => RowsOf(Lab, measured).Where(row => row.Rule == rule.Name && row.Error < bound)
            .Select(row => row.Cost).DefaultIfEmpty(double.NaN).Min()).Select(Time);
        return ["`" + rule.Name + "`", rule.Order.ToString(CultureInfo.InvariantCulture), Error(inGame.Error), Time(inGame.Nanoseconds), .. costs];
    }

    /// <summary>The cheapest integrator for every error, and the ratio of RungeKutta4's cost to its cost.</summary>
    private static string[] Motion(string name, Measured measured)
    {
        List<CostRow> rows = [.. RowsOf(name, measured)];
        return ["`" + name + "`", .. Bounds.Select(Cell)];

        string Cell(double bound)
        {
            CostRow[] below = [.. rows.Where(row => row.Error < bound)];
            // of costs that the clock cannot separate, the first of the catalogue
            CostRow best = below.First(row => row.Cost <= SameCost * below.Min(one => one.Cost));
            double other = below.Where(row => row.Rule == "RungeKutta4").Select(row => row.Cost).DefaultIfEmpty(double.NaN).Min();
            return string.Create(CultureInfo.InvariantCulture, $"`{best.Rule}` {best.Step:G2} s: {Time(best.Cost)} ({Time(other / best.Cost)})");
        }
    }

    private static string OneBody(string what, Measured measured)
    {
        IReadOnlyDictionary<string, string> line = measured.Bench.FirstOrDefault(line => line["what"] == what && line["bodies"] == "1")
            ?? throw new InvalidDataException($"bench.csv has no \"{what}\"");
        return Time(Number(line["nanosecondsPerBodyStep"]));
    }

    /// <summary>µs per simulated second, of every integrator and step.</summary>
    private static IEnumerable<CostRow> RowsOf(string scene, Measured measured) => measured.Cost.Where(line => line["scene"] == scene).Select(line => new CostRow(
        line["integrator"], Number(line["step"]), Math.Max(Number(line["angleError"]), Number(line["positionError"])),
        Number(line["nanosecondsPerStep"]), 1e6 * Number(line["secondsPerSimulatedSecond"])));

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static string Error(double error) => error >= 0.1
        ? error.ToString("0.0", CultureInfo.InvariantCulture)
        : error.ToString("0e-0", CultureInfo.InvariantCulture);

    // two digits: the third is noise
    private static string Time(double time)
    {
        if (!double.IsFinite(time))
            return "–";

        double unit = Math.Pow(10, Math.Floor(Math.Log10(time)) - 1);
        return (Math.Round(time / unit) * unit).ToString(unit >= 1 ? "N0" : unit >= 0.1 ? "0.0" : unit >= 0.01 ? "0.00" : "0.000", CultureInfo.InvariantCulture);
    }

    private sealed record CostRow(string Rule, double Step, double Error, double Nanoseconds, double Cost);
}
