using ScottPlot;
using SkiaSharp;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>What all pictures have in common: size, fonts, formats.</summary>
internal static class Pictures
{
    /// <summary>Width of every picture, pixels.</summary>
    public const int Width = 1000;

    private const int UsualHeight = 560;

    /// <summary>A plot with a title.</summary>
    public static Plot New(string title)
    {
        title = Visible.Line(PictureWords.Say(title));
        Fonts.Default = PictureWords.Font;
        Plot plot = new();
        plot.Font.Set(Fonts.Default);
        plot.Title(title, 20);
        if (Lacks(Fonts.Default, title))
        {
            // the name of a scene may be in any language
            plot.Axes.Title.Label.SetBestFont();
        }

        plot.Legend.FontSize = 15;
        plot.Axes.Bottom.TickLabelStyle.FontSize = 14;
        plot.Axes.Left.TickLabelStyle.FontSize = 14;
        plot.Axes.Right.TickLabelStyle.FontSize = 14;
        return plot;
    }

    /// <summary>Writes a plot in the format of the path's extension.</summary>
    public static void Save(Plot plot, string path, int height = UsualHeight)
    {
        if (Path.GetExtension(path) == ".svg")
            plot.SaveSvg(path, Width, height);
        else
            plot.SavePng(path, Width, height);
    }

    /// <summary>The upper end of an axis from 0, a little above the largest value.</summary>
    public static double Top(double largest) => largest > 0 && largest < double.MaxValue / 2 ? 1.08 * largest : 1;

    /// <summary>Prints a note on standard error where there is no font, so that pictures have no text.</summary>
    public static void NoteIfThereAreNoFonts()
    {
        // without fonts, Skia counts one without a name
        if (SKFontManager.Default.FontFamilies.All(string.IsNullOrEmpty))
            Terminal.Note("no font on this machine: pictures have lines but no text; install one (Debian: fonts-dejavu-core)");
    }

    private static bool Lacks(string font, string text)
    {
        using SKTypeface face = SKTypeface.FromFamilyName(font);
        return !face.ContainsGlyphs(text);
    }
}
