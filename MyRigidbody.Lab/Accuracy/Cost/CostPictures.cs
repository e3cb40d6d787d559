using RigidBodyDynamics.Lab.Output;
using ScottPlot;
using ScottPlot.Plottables;
using ScottPlot.TickGenerators;

namespace RigidBodyDynamics.Lab;

/// <summary>Error against time, both logarithmic, one line for each integrator: lower left is better.</summary>
internal static class CostPictures
{
    /// <summary>Height, pixels: errors span sixteen powers of ten.</summary>
    public const int Height = 720;

    // an error of zero has no logarithm
    private const double Smallest = 1e-17, Grey = 0.35;

    // after Okabe and Ito: distinguishable by colour-blind readers too, and by their markers without colour
    private static readonly Color[] Colors =
        [.. new[] { "#e69f00", "#1a1a1a", "#56b4e9", "#999999", "#cc79a7", "#009e73", "#7a5195", "#0072b2", "#d55e00", "#b00020" }.Select(Color.FromHex)];

    private static readonly MarkerShape[] Markers =
    [
        MarkerShape.OpenCircle, MarkerShape.FilledCircle, MarkerShape.OpenSquare, MarkerShape.FilledSquare, MarkerShape.OpenDiamond,
        MarkerShape.FilledDiamond, MarkerShape.OpenTriangleUp, MarkerShape.FilledTriangleUp, MarkerShape.FilledTriangleDown, MarkerShape.Cross,
    ];

    /// <summary>The diagram of a motion.</summary>
    public static Plot Of(CostFindings found)
    {
        Plot plot = Pictures.New($"{found.Motion.Scene.Name}: error against time");
        for (int i = 0; i < Rules.All.Count; i++)
            Add(plot, found, i);

        AddFloor(plot, found.Motion.Truth);
        bool hasOthers = found.Motion.IsSolved && found.Motion.Scene.Name == OtherEngine.Motion;
        Frame(plot, found, hasOthers);
        if (hasOthers)
            AddOthers(plot);

        return plot;
    }

    private static void Add(Plot plot, CostFindings found, int i)
    {
        Rule rule = Rules.All[i];
        Trial[] trials = [.. found.Of(rule).Where(trial => double.IsFinite(trial.Error))];
        Scatter line = plot.Add.Scatter(
            trials.Select(trial => Math.Log10(trial.Cost)).ToArray(),
            trials.Select(trial => Log(trial.Error)).ToArray(),
            Colors[i % Colors.Length]);
        line.LegendText = rule.Name;
        line.LineWidth = 2;
        line.LinePattern = i < Colors.Length ? LinePattern.Solid : LinePattern.Dotted;
        line.MarkerShape = Markers[i % Markers.Length];
        line.MarkerSize = 9;
        line.MarkerLineWidth = 2;
    }

    private static void AddFloor(Plot plot, Truth truth)
    {
        HorizontalLine floor = plot.Add.HorizontalLine(Log(Math.Max(truth.Floor, truth.Uncertainty)), 1.5f, ScottPlot.Colors.Black);
        floor.LinePattern = LinePattern.Dashed;
        floor.LegendText = PictureWords.Say("attainable in double");
    }

    /// <summary>Most points are close together, so a label may be apart from its point, connected by a line.</summary>
    private static void AddOthers(Plot plot)
    {
        Color grey = ScottPlot.Colors.Black.WithAlpha(1 - Grey);
        LabelPlaces places = new(plot.Axes.GetLimits());
        foreach (Scatter line in plot.GetPlottables().OfType<Scatter>())
            places.Avoid(line.Data.GetScatterPoints());

        foreach (OtherEngine engine in OtherEngine.All)
            places.Avoid([At(engine)]);

        // from the right, so that the lines do not cross
        foreach (OtherEngine engine in OtherEngine.All.OrderByDescending(engine => engine.Cost))
        {
            string name = PictureWords.Say(engine.Name);
            Coordinates label = places.Next(At(engine), name);
            plot.Add.Line(At(engine), label).Color = grey;
            plot.Add.Marker(At(engine), MarkerShape.Eks, 9, grey).MarkerLineWidth = 2;
            Text text = plot.Add.Text(name, label);
            text.LabelFontSize = LabelPlaces.FontSize;
            text.LabelFontColor = grey;
            text.LabelAlignment = Alignment.MiddleLeft;
        }

        plot.Legend.ManualItems.Add(new LegendItem { LabelText = PictureWords.Say("other engines, 1/50 s"), MarkerShape = MarkerShape.Eks, MarkerColor = grey, MarkerSize = 9 });
    }

    private static Coordinates At(OtherEngine engine) => new(Math.Log10(engine.Cost), Log(engine.AngleError));

    private static void Frame(Plot plot, CostFindings found, bool hasOthers)
    {
        Trial[] trials = [.. found.Trials.Where(trial => double.IsFinite(trial.Error))];
        double left = trials.Min(trial => Math.Log10(trial.Cost)), right = trials.Max(trial => Math.Log10(trial.Cost));
        double bottom = Math.Min(trials.Min(trial => Log(trial.Error)), Log(found.Motion.Truth.Floor));
        double top = Math.Max(1, trials.Max(trial => Log(trial.Error)) + 0.5), largest = top;
        if (hasOthers)
        {
            // room for their labels
            right = Math.Max(right, OtherEngine.All.Max(engine => At(engine).X) + 1.6);
            top += 4.6;
        }

        plot.Axes.SetLimits(left - 0.2, right + 0.2, bottom - 0.5, top);
        plot.XLabel(PictureWords.Say("time for a simulated second of one body, s"), 16);
        plot.YLabel(PictureWords.Say("largest error, rad or m"), 16);
        plot.Axes.Bottom.TickGenerator = Powers(1, right);
        plot.Axes.Left.TickGenerator = Powers(2, largest);
        plot.Grid.MinorLineColor = ScottPlot.Colors.Black.WithAlpha(0.05);
        plot.Legend.FontSize = 13;
        plot.ShowLegend(Edge.Right);
    }

    private static NumericManual Powers(int every, double last)
    {
        NumericManual ticks = new();
        for (int power = -18; power <= last + 1; power++)
        {
            if (power % every == 0)
                ticks.AddMajor(power, FormattableString.Invariant($"1e{power}"));
            else
                ticks.AddMinor(power);
        }

        return ticks;
    }

    private static double Log(double error) => Math.Log10(Math.Max(error, Smallest));
}
