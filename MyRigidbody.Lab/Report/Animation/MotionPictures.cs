using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;
using ScottPlot;
using ScottPlot.Plottables;

namespace RigidBodyDynamics.Lab.Animation;

/// <summary>The page's plots and replay of a motion as pictures, for a report on paper and for slides.</summary>
internal static class MotionPictures
{
    // more would cover each other
    private const int MostBodies = 8;

    // as on the page; different line styles for print without colour
    private static readonly Color[] Colors =
        [.. new[] { "#1f5fa8", "#c8550a", "#2c7a3f", "#7a3fa0", "#b3261e", "#0b7285", "#1b1d1f", "#8a6d00" }.Select(Color.FromHex)];

    private static readonly LinePattern[] Lines = [LinePattern.Solid, LinePattern.Dashed, LinePattern.Dotted, LinePattern.DenselyDashed];

    /// <summary>The pictures of every motion: energy and abs(L) over time, each as PNG and SVG, and the replay.</summary>
    /// <param name="name">The name of the scene.</param>
    /// <param name="motion">The motion.</param>
    /// <param name="files">Where they are written.</param>
    public static void Write(string name, Motion motion, Files files)
    {
        foreach (string format in new[] { ".png", ".svg" })
        {
            files.Write("energy" + format, to => Pictures.Save(Energy(name, motion), to));
            files.Write("momentum" + format, to => Pictures.Save(Momentum(name, motion), to));
        }

        files.Write("replay.png", to => ReplayPicture.Write(name, motion, to));
    }

    private static Plot Energy(string name, Motion motion) =>
        Of($"{name}: kinetic energy", "energy, J", motion, (state, mass) => Conserved.KineticEnergy(state, mass));

    private static Plot Momentum(string name, Motion motion) =>
        Of($"{name}: length of the angular momentum", "abs(L), kg m²/s", motion, (state, mass) => Conserved.AngularMomentum(state, mass).Length);

    private static Plot Of(string title, string label, Motion motion, Func<BodyState, MassProperties, double> quantity)
    {
        List<Track> shown = [.. motion.Tracks.Take(MostBodies)];
        Plot plot = Pictures.New(shown.Count < motion.BodiesInScene ? $"{title}, {shown.Count} of {motion.BodiesInScene} bodies" : title);
        double[] time = [.. motion.At.Select(motion.Steps.StartOf)];
        double largest = 0;
        for (int i = 0; i < shown.Count; i++)
        {
            Track track = shown[i];
            double[] values = [.. track.States.Select(state => quantity(state, track.Mass))];
            largest = Math.Max(largest, values.Max());
            Scatter line = plot.Add.ScatterLine(time, values, Colors[i]);
            line.LegendText = track.Name;
            line.LinePattern = Lines[i % Lines.Length];
            line.LineWidth = 2.5f;
        }

        plot.XLabel(PictureWords.Say("time, s"), 16);
        plot.YLabel(PictureWords.Say(label), 16);
        plot.Axes.SetLimitsX(0, time[^1] > 0 ? time[^1] : 1);
        plot.Axes.SetLimitsY(0, Pictures.Top(largest));
        plot.ShowLegend(Edge.Bottom);
        return plot;
    }
}
