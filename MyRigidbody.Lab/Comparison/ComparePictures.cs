using RigidBodyDynamics.Lab.Output;
using ScottPlot;
using ScottPlot.Hatches;
using ScottPlot.Plottables;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A comparison as pictures.</summary>
internal static class ComparePictures
{
    private static readonly Color Blue = Color.FromHex("#1f5fa8"), Orange = Color.FromHex("#c8550a");

    /// <summary>Distance and angle over time; solid and dashed, so that they can be distinguished without colour.</summary>
    public static Plot Apart(string title, IReadOnlyList<Compared> course)
    {
        Plot plot = Pictures.New(title);
        double[] time = [.. course.Select(row => row.Apart.Time)];
        Scatter distance = plot.Add.ScatterLine(time, course.Select(row => row.Apart.Distance).ToArray(), Blue);
        distance.LegendText = PictureWords.Say("distance (left)");
        Scatter angle = plot.Add.ScatterLine(time, course.Select(row => row.Apart.Angle * 180 / Math.PI).ToArray(), Orange);
        angle.LegendText = PictureWords.Say("angle (right)");
        angle.LinePattern = LinePattern.Dashed;
        angle.Axes.YAxis = plot.Axes.Right;
        distance.LineWidth = angle.LineWidth = 2.5f;
        plot.XLabel(PictureWords.Say("time, s"), 16);
        plot.YLabel(PictureWords.Say("distance, m"), 16);
        plot.Axes.Right.Label.Text = PictureWords.Say("angle, °");
        plot.Axes.Right.Label.FontSize = 16;
        plot.Axes.Left.Label.ForeColor = Blue;
        plot.Axes.Right.Label.ForeColor = Orange;
        plot.Axes.SetLimitsY(0, Pictures.Top(course.Max(row => row.Apart.Distance)), plot.Axes.Left);
        double turned = course.Max(row => row.Apart.Angle) * 180 / Math.PI;
        // usually up to half a revolution; a recording is often so close that it would not be visible there
        plot.Axes.SetLimitsY(0, turned > 19 ? 190 : Pictures.Top(turned), plot.Axes.Right);
        plot.Axes.SetLimitsX(0, time[^1]);
        plot.ShowLegend(Edge.Bottom);
        return plot;
    }

    /// <summary>The share of each rule in the mean distance and in the mean difference of turns, per cent.</summary>
    public static Plot Rules(SceneDescription scene, Findings found)
    {
        Plot plot = Pictures.New($"{scene.Name}: which rule makes how much of the difference");
        IReadOnlyList<RuleShare> shares = found.Shares.Shares;
        Add(plot, shares, share => share.Distance / found.Shares.Whole.MeanDistance, 0.2, Fill(Blue, null));
        Add(plot, shares, share => share.Turn / found.Shares.Whole.MeanTurn, -0.2, Fill(Orange, new Striped()));
        plot.Axes.Left.SetTicks(
            [.. Enumerable.Range(0, shares.Count).Select(i => (double)(shares.Count - 1 - i))],
            [.. shares.Select(share => PictureWords.Say(share.Difference.Name))]);
        plot.Axes.Left.TickLabelStyle.FontSize = 16;
        plot.XLabel(PictureWords.Say("share, %"), 16);
        plot.Axes.Margins(bottom: 0.08, top: 0.08, left: 0.12, right: 0.12);
        plot.Legend.ManualItems.Add(Entry(PictureWords.Say("of the distance"), Fill(Blue, null)));
        plot.Legend.ManualItems.Add(Entry(PictureWords.Say("of the turn"), Fill(Orange, new Striped())));
        plot.ShowLegend(Edge.Bottom);
        return plot;
    }

    private static FillStyle Fill(Color color, IHatch? hatch) =>
        new() { Color = color, Hatch = hatch, HatchColor = Colors.White.WithAlpha(0.6) };

    private static LegendItem Entry(string text, FillStyle fill) => new() { LabelText = text, FillStyle = fill };

    private static void Add(
        Plot plot,
        IReadOnlyList<RuleShare> shares,
        Func<RuleShare, double> share,
        double offset,
        FillStyle fill)
    {
        Bar[] bars = [.. shares.Select((rule, i) =>
        {
            double percent = 100 * share(rule);
            return new Bar
            {
                Position = shares.Count - 1 - i + offset,
                Value = Guard.IsFinite(percent) ? percent : 0,
                Size = 0.36,
                FillColor = fill.Color,
                FillHatch = fill.Hatch,
                FillHatchColor = fill.HatchColor,
                LineWidth = 0,
                Label = Guard.IsFinite(percent) ? FormattableString.Invariant($"{percent:F1} %") : "–",
            };
        })];
        BarPlot plotted = plot.Add.Bars(bars);
        plotted.Horizontal = true;
        plotted.ValueLabelStyle.FontSize = 13;
    }
}
