using System.Reflection;
using System.Text.Encodings.Web;
using System.Text.Unicode;
using Fluid;
using Fluid.Values;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>Makes one file of a page: template, style, scripts and data, and nothing that a browser would have to fetch.</summary>
internal static class PageWriter
{
    private const string Plotting = "Plotly.NET", PlottingScript = ".min.js";

    // in this order; each of our own adds to window.report
    private static readonly string[] Scripts = ["page.js", "solid.js", "motion.js", "stage.js", "replay.js", "plots.js", "cost.js"];

    private static readonly Lazy<IFluidTemplate> Template = new(() => new FluidParser().Parse(Resource("report.liquid")));

    // every letter of every language as it is, and what HTML gives a meaning escaped
    private static readonly HtmlEncoder Encoder = HtmlEncoder.Create(UnicodeRanges.All);

    private static readonly TemplateOptions Options = NewOptions();

    /// <summary>Writes a page to a file.</summary>
    public static void Write(Page page, string path) => File.WriteAllText(path, Html(page));

    /// <summary>The page as HTML.</summary>
    public static string Html(Page page)
    {
        TemplateContext context = new(new Dictionary<string, object>(), Options);
        Replay? replay = page.Sections.OfType<Replay>().FirstOrDefault();
        context.SetValue("page", page);
        context.SetValue("style", Resource("report.css"));
        context.SetValue("plotting", Library());
        context.SetValue("scripts", Scripts.Select(Resource).ToArray());
        context.SetValue("data", replay is null ? "null" : MotionJson.Of(replay.Motion));
        context.SetValue("cost", page.Sections.OfType<CostDiagrams>().FirstOrDefault() is CostDiagrams cost ? CostJson.Of(cost) : string.Empty);
        return Template.Value.Render(context, Encoder);
    }

    /// <summary>plotly.js, as the package Plotly.NET carries it.</summary>
    internal static string Library()
    {
        Assembly package = Assembly.Load(Plotting);
        string name = package.GetManifestResourceNames().FirstOrDefault(resource => resource.EndsWith(PlottingScript, StringComparison.Ordinal))
            ?? throw new InvalidOperationException($"the package {Plotting} has no resource *{PlottingScript}; this version of it carries plotly.js elsewhere");
        return Text(package, name);
    }

    private static TemplateOptions NewOptions()
    {
        TemplateOptions options = new()
        {
            MemberAccessStrategy = new UnsafeMemberAccessStrategy { MemberNameStrategy = MemberNameStrategies.CamelCase },
        };
        options.Filters.AddFilter("word", (input, arguments, _) =>
        {
            Word word = input.ToObjectValue() as Word ?? Words.All[input.ToStringValue()];
            return new StringValue(InBoth(arguments.Count == 0 ? word : word.With([.. arguments.Values.Select(value => value.ToObjectValue())])), encode: false);
        });
        return options;
    }

    /// <summary>A text in both languages; style shows one of them.</summary>
    private static string InBoth(Word word) => word.En == word.Zh
        ? $"<bdi>{Encoder.Encode(word.En)}</bdi>"
        : $"<span lang=\"en\">{Encoder.Encode(word.En)}</span><span lang=\"zh\">{Encoder.Encode(word.Zh)}</span>";

    private static string Resource(string name) => Text(typeof(PageWriter).Assembly, "report/" + name);

    private static string Text(Assembly assembly, string name)
    {
        using StreamReader reader = new(assembly.GetManifestResourceStream(name) ?? throw new InvalidOperationException($"no resource {name}"));
        return reader.ReadToEnd();
    }
}
