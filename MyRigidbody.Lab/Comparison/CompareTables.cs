using System.Globalization;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A comparison for the terminal.</summary>
internal static class CompareTables
{
    private const int Rows = 10;

    /// <summary>The motion, the rules and the frame rates of a pair.</summary>
    public static void Print(Findings found)
    {
        Terminal.WriteText($"{found.Pair.Mine.Name} ({found.Pair.Mine.Rule.Name}) beside {found.Pair.Default.Name} ({found.Pair.Default.Rule.Name}), in s, m, rad/s, °");
        Terminal.Write(Motion(found));
        Terminal.WriteText("Why they differ");
        Terminal.Write(Differences(found.Shares));
        Terminal.WriteText("and the share of each rule, exchanged one after another");
        Terminal.Write(Shares(found.Shares));
        Terminal.WriteText("share: how far the exchange moves the body on the way from mine to Unity's, on average "
            + "over the run; below zero where it takes back what another gives. "
            + "alone: how far mine moves if only this rule is exchanged" + IfNotTheLabs(found) + ". turn: whole revolutions counted.");
        Terminal.WriteLine();
        Terminal.WriteText(InWords(found));
        if (found.FrameRates.Count > 0)
        {
            Terminal.WriteLine();
            Terminal.WriteText($"{found.Pair.Default.Name} when AddForce is called in Update instead of FixedUpdate");
            Terminal.Write(FrameRates(found.FrameRates));
        }
    }

    /// <summary>How far the two are apart and why, in two sentences.</summary>
    public static string InWords(Findings found)
    {
        RuleShares shares = found.Shares;
        return $"On average over the run they are {Length(shares.Whole.MeanDistance)} m apart"
            + Makers(shares.Shares, share => share.Distance, shares.Whole.MeanDistance)
            + $" One has turned {Degrees(shares.Whole.MeanTurn)}° further than the other"
            + Makers(shares.Shares, share => share.Turn, shares.Whole.MeanTurn);
    }

    private static TextTable Motion(Findings found)
    {
        TextTable table = new TextTable("t", "mine at", "spin", "Unity's at", "spin", "apart", "angle").RightAligned(0, 2, 4, 5, 6);
        int last = found.Course.Count - 1;
        foreach (int at in Enumerable.Range(0, Rows + 1).Select(i => (int)((long)i * last / Rows)).Distinct())
        {
            Compared row = found.Course[at];
            table.AddRow(
                Fixed(row.Apart.Time, 2),
                Position(row.Mine.Position),
                Fixed(row.Mine.AngularVelocity.Length, 2),
                Position(row.Default.Position),
                Fixed(row.Default.AngularVelocity.Length, 2),
                Length(row.Apart.Distance),
                Degrees(row.Apart.Angle));
        }

        return table;
    }

    private static TextTable Differences(RuleShares found)
    {
        TextTable table = new("rule", "mine", "Unity's");
        foreach (RuleShare share in found.Shares)
            table.AddRow(share.Difference.Name, share.Difference.Mine, share.Difference.Unitys);

        return table;
    }

    private static TextTable Shares(RuleShares found)
    {
        TextTable table = new TextTable("rule", "share of distance", "share of turn", "alone").RightAligned();
        foreach (RuleShare share in found.Shares)
        {
            table.AddRow(
                share.Difference.Name,
                $"{Length(share.Distance)} m {Percent(share.Distance, found.Whole.MeanDistance),8}",
                $"{Degrees(share.Turn)}° {Percent(share.Turn, found.Whole.MeanTurn),8}",
                $"{Length(share.Alone.MeanDistance)} m {Degrees(share.Alone.MeanTurn),8}°");
        }

        table.AddRow(
            "all",
            $"{Length(found.Shares.Sum(share => share.Distance))} m {Percent(found.Whole.MeanDistance, found.Whole.MeanDistance),8}",
            $"{Degrees(found.Shares.Sum(share => share.Turn))}° {Percent(found.Whole.MeanTurn, found.Whole.MeanTurn),8}",
            string.Empty);
        return table;
    }

    private static TextTable FrameRates(IReadOnlyList<FrameRate> rates)
    {
        TextTable table = new TextTable("frames a second", "arrow force ×", "\"r\" torque ×", "apart at the end", "turns differ by").RightAligned(0, 1, 2, 3, 4);
        foreach (FrameRate rate in rates)
        {
            table.AddRow(
                rate.FramesPerSecond.ToString(CultureInfo.InvariantCulture),
                Ratio(rate.Impulse),
                Ratio(rate.AngularImpulse),
                Length(rate.Apart.Last.Distance) + " m",
                Degrees(rate.Apart.Last.Turn) + "°");
        }

        return table;
    }

    /// <summary>The rules whose share is at least a hundredth.</summary>
    private static string Makers(IReadOnlyList<RuleShare> shares, Func<RuleShare, double> of, double whole)
    {
        string[] makers = [.. shares.Where(share => Math.Abs(of(share)) >= 0.01 * whole && whole > 0)
            .Select(share => $"{Language.Say(share.Difference.Name)} {Percent(of(share), whole)}")];
        return makers.Length > 0 ? ": " + string.Join(", ", makers) + "." : ".";
    }

    private static string Position(Vector3d p) => $"{Fixed(p.X, 2)} {Fixed(p.Y, 2)} {Fixed(p.Z, 2)}";

    internal static string Length(double metres) =>
        metres != 0 && Math.Abs(metres) < 5e-4 && Math.Abs(metres) >= 1e-9 ? metres.ToString("0.0e+0", CultureInfo.InvariantCulture) : Fixed(metres, 3);

    internal static string Degrees(double angle)
    {
        double degrees = angle * 180 / Math.PI;
        return degrees != 0 && Math.Abs(degrees) < 5e-3 && Math.Abs(degrees) >= 1e-9 ? degrees.ToString("0.0e+0", CultureInfo.InvariantCulture) : Fixed(degrees, Math.Abs(degrees) < 1000 ? 2 : 0);
    }

    internal static string Percent(double part, double whole) => whole > 0 ? Fixed(100 * part / whole, 1) + " %" : "–";

    internal static string Ratio(double ratio) => Guard.IsFinite(ratio) ? Fixed(ratio, 2) : "–";

    private static string IfNotTheLabs(Findings found) => found.Pair.Mine.Rule == Rules.LabEuler
        ? string.Empty
        : $" (with {found.Pair.Mine.Rule.Name}, for the other rules are exchanged in the lab's steps)";

    private static string Fixed(double value, int digits)
    {
        double rounded = Math.Round(value, digits);
        // no minus before a zero
        return (rounded == 0 ? 0 : rounded).ToString("F" + digits, CultureInfo.InvariantCulture);
    }
}
