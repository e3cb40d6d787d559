using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>Accuracy against time as a table for the terminal.</summary>
internal static class CostTables
{
    /// <summary>The meaning of the columns.</summary>
    public const string Legend =
        "at 1/50: error (larger of rad and m) in steps of 1/50 s. ns: time for a step of one body. × lab: the same in steps of LabEuler, "
        + "which leaves out I⁻¹ τ where no torque acts. "
        + "to 1e-3 ...: the least that an error below it costs, in µs per simulated second and body. "
        + "An integrator's own drag and limits count as error, and so does a step that misses the beginning of an effect.";

    /// <summary>One row for each integrator.</summary>
    public static void Print(CostFindings found)
    {
        string[] bounds = [.. CostFindings.Bounds.Select(bound => "to " + Exponent(bound))];
        TextTable table = new TextTable(["integrator", "at 1/50", "ns", "× lab", .. bounds]).RightAligned();
        foreach (Rule row in Rules.All)
        {
            Trial game = found.InGame(row);
            IEnumerable<string> costs = CostFindings.Bounds.Select(bound => Number(1e6 * (found.Cheapest(row, bound)?.Cost ?? double.NaN)));
            string[] cells = [row.Name, Error(game.Error), Number(game.NanosecondsPerStep), Number(found.TimesLab(row)), .. costs];
            table.AddRow(cells);
        }

        Terminal.WriteText($"{found.Motion.Scene.Name}: {found.Motion.Scene.About}");
        Terminal.WriteText($"{found.Motion.Origin}; attainable: {Error(found.Motion.Truth.Floor)}");
        Terminal.Write(table);
    }

    /// <summary>The advice for each error, in a sentence; errors with the same advice are named together.</summary>
    public static string InWords(CostFindings found)
    {
        IEnumerable<string> parts = CostFindings.Bounds.GroupBy(found.Cheapest).Select(same =>
        {
            string bounds = "to " + string.Join(", ", same.Select(Exponent));
            return same.Key is Trial best
                ? $"{bounds} {best.Rule.Name} in steps of {Step(best.Step)} s ({Number(1e6 * best.Cost)} µs)"
                : bounds + " none of these steps";
        });
        return $"{found.Motion.Scene.Name}: {string.Join("; ", parts)}.";
    }

    /// <summary>An error with two digits.</summary>
    public static string Error(double error) =>
        double.IsFinite(error) ? error.ToString("0.0e+0", CultureInfo.InvariantCulture) : "∞";

    /// <summary>A time or a ratio with three digits at most.</summary>
    public static string Number(double value) =>
        !double.IsFinite(value) ? "–"
        : value is >= 99_999.5 or < 0.001 ? value.ToString("0.0e+0", CultureInfo.InvariantCulture)
        : value.ToString(value >= 100 ? "0" : value >= 10 ? "0.0" : value >= 1 ? "0.00" : "0.000", CultureInfo.InvariantCulture);

    /// <summary>A step length with the digits that it has.</summary>
    public static string Step(double step) => step.ToString("G4", CultureInfo.InvariantCulture);

    /// <summary>A step length with all of its digits, to be typed.</summary>
    public static string ExactStep(double step) => step.ToString("R", CultureInfo.InvariantCulture);

    private static string Exponent(double bound) => bound.ToString("0e+0", CultureInfo.InvariantCulture);
}
