using System.Reflection;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>Writes a page as one file: template, style, scripts and data, so that a browser fetches nothing.</summary>
internal static class PageWriter
{
    private const string Plotting = "Plotly.NET", PlottingScript = ".min.js";

    // in this order; each of our own adds to window.report
    private static readonly string[] Scripts = ["page.js", "solid.js", "motion.js", "stage.js", "look.js", "replay.js", "plots.js", "cost.js"];

    private static readonly PageTemplate Template = new("report.liquid", Words.All);

    /// <summary>Writes a page to a file.</summary>
    public static void Write(Page page, string path) => File.WriteAllText(path, Html(page));

    /// <summary>The page as HTML.</summary>
    /// <param name="page">The page.</param>
    /// <param name="plotting">The plotting library; the one that comes with the program if absent.</param>
    public static string Html(Page page, string? plotting = null)
    {
        Replay? replay = page.Sections.OfType<Replay>().FirstOrDefault();
        return Template.Render(
            ("page", page),
            ("style", PageTemplate.Resource("report.css")),
            ("plotting", plotting ?? Library()),
            ("scripts", Scripts.Select(PageTemplate.Resource).ToArray()),
            ("data", replay is null ? "null" : MotionJson.Of(replay.Motion)),
            ("cost", page.Sections.OfType<CostDiagrams>().FirstOrDefault() is CostDiagrams cost ? CostJson.Of(cost) : string.Empty));
    }

    /// <summary>plotly.js, as the package Plotly.NET carries it.</summary>
    internal static string Library()
    {
        Assembly package = Assembly.Load(Plotting);
        string name = package.GetManifestResourceNames().FirstOrDefault(resource => resource.EndsWith(PlottingScript, StringComparison.Ordinal))
            ?? throw new InvalidOperationException($"the package {Plotting} has no resource *{PlottingScript}; this version of it carries plotly.js elsewhere");
        return PageTemplate.Text(package, name);
    }
}
