using System.Globalization;
using Spectre.Console;
using Spectre.Console.Rendering;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A comparison as a person reads it on a terminal.</summary>
internal static class CompareTables
{
    private const int Rows = 10;

    /// <summary>The motion, the rules and the frame rates of a pair.</summary>
    public static IRenderable Of(Findings found)
    {
        List<IRenderable> parts =
        [
            new Text($"{found.Pair.Mine.Name} ({found.Pair.Mine.Integrator}) beside {found.Pair.Default.Name} ({found.Pair.Default.Integrator})"),
            Motion(found),
            new Text("Why they part: the rules of DefaultRigidbody, put in one after another"),
            Rules(found.Shares),
            new Text("share: how far the exchange moves the body on the way from mine to Unity's, on average over the run; below zero where"),
            new Text("it takes back what another gives. alone: how far mine moves if only this rule is exchanged. turn: whole turns counted."),
            new Text(Environment.NewLine + InWords(found)),
        ];
        if (found.FrameRates.Count > 0)
        {
            parts.Add(new Text(Environment.NewLine + $"{found.Pair.Default.Name} when AddForce is called in Update instead of FixedUpdate"));
            parts.Add(FrameRates(found.FrameRates));
        }

        return new Spectre.Console.Rows(parts);
    }

    /// <summary>How far they part and what makes it, in two sentences.</summary>
    public static string InWords(Findings found)
    {
        RuleShares shares = found.Shares;
        return $"On average over the run they are {Length(shares.Whole.MeanDistance)} m apart"
            + Makers(shares.Shares, share => share.Distance, shares.Whole.MeanDistance)
            + $" One has turned {Degrees(shares.Whole.MeanTurn)}° further than the other"
            + Makers(shares.Shares, share => share.Turn, shares.Whole.MeanTurn);
    }

    private static Table Motion(Findings found)
    {
        Table table = Terminal.NewTable("t, s", "mine: position, m", "spin, rad/s", "Unity's: position, m", "spin, rad/s", "apart, m", "angle, °");
        foreach (int column in new[] { 0, 2, 4, 5, 6 })
        {
            table.Columns[column].RightAligned();
        }

        int last = found.Course.Count - 1;
        foreach (int at in Enumerable.Range(0, Rows + 1).Select(i => (int)((long)i * last / Rows)).Distinct())
        {
            Compared row = found.Course[at];
            Add(
                table,
                Fixed(row.Apart.Time, 2),
                Position(row.Mine.Position),
                Fixed(row.Mine.AngularVelocity.Length, 3),
                Position(row.Default.Position),
                Fixed(row.Default.AngularVelocity.Length, 3),
                Length(row.Apart.Distance),
                Degrees(row.Apart.Angle));
        }

        return table;
    }

    private static Table Rules(RuleShares found)
    {
        Table table = Terminal.NewTable("rule", "mine", "Unity's", "share of distance", "", "share of turn", "", "alone, m", "turn alone");
        foreach (int column in Enumerable.Range(3, 6))
        {
            table.Columns[column].RightAligned();
        }

        foreach (RuleShare share in found.Shares)
        {
            Add(
                table,
                share.Rule.Name,
                share.Rule.Mine,
                share.Rule.Unitys,
                Length(share.Distance) + " m",
                Percent(share.Distance, found.Whole.MeanDistance),
                Degrees(share.Turn) + "°",
                Percent(share.Turn, found.Whole.MeanTurn),
                Length(share.Alone.MeanDistance),
                Degrees(share.Alone.MeanTurn) + "°");
        }

        table.AddEmptyRow();
        Add(
            table,
            "all",
            string.Empty,
            string.Empty,
            Length(found.Shares.Sum(share => share.Distance)) + " m",
            "100 %",
            Degrees(found.Shares.Sum(share => share.Turn)) + "°",
            "100 %",
            string.Empty,
            string.Empty);
        return table;
    }

    private static Table FrameRates(IReadOnlyList<FrameRate> rates)
    {
        Table table = Terminal.NewTable("frames a second", "push of the arrows ×", "turn of \"r\" ×", "apart at the end, m", "turned apart at the end, °");
        foreach (TableColumn column in table.Columns)
        {
            column.RightAligned();
        }

        foreach (FrameRate rate in rates)
        {
            Add(
                table,
                rate.FramesPerSecond.ToString(CultureInfo.InvariantCulture),
                Ratio(rate.Impulse),
                Ratio(rate.AngularImpulse),
                Length(rate.Apart.Last.Distance),
                Degrees(rate.Apart.Last.Turn));
        }

        return table;
    }

    /// <summary>The rules that make at least a hundredth of a difference.</summary>
    private static string Makers(IReadOnlyList<RuleShare> shares, Func<RuleShare, double> of, double whole)
    {
        string[] makers = [.. shares.Where(share => Math.Abs(of(share)) >= 0.01 * whole && whole > 0)
            .Select(share => $"{share.Rule.Name} {Percent(of(share), whole)}")];
        return makers.Length > 0 ? ": " + string.Join(", ", makers) + "." : ".";
    }

    private static void Add(Table table, params string[] cells) => table.AddRow(cells.Select(cell => new Text(cell)));

    private static string Position(Vector3d p) => $"({Fixed(p.X, 3)}, {Fixed(p.Y, 3)}, {Fixed(p.Z, 3)})";

    private static string Length(double metres) =>
        metres != 0 && Math.Abs(metres) < 5e-4 ? metres.ToString("0.0e+0", CultureInfo.InvariantCulture) : Fixed(metres, 3);

    private static string Degrees(double angle)
    {
        double degrees = angle * 180 / Math.PI;
        return degrees != 0 && Math.Abs(degrees) < 5e-3 ? degrees.ToString("0.0e+0", CultureInfo.InvariantCulture) : Fixed(degrees, Math.Abs(degrees) < 1000 ? 2 : 0);
    }

    private static string Percent(double part, double whole) => whole > 0 ? Fixed(100 * part / whole, 1) + " %" : "–";

    private static string Ratio(double ratio) => Guard.IsFinite(ratio) ? Fixed(ratio, 2) : "–";

    private static string Fixed(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture);
}
