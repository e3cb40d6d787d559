using System.Reflection;
using System.Text.Encodings.Web;
using System.Text.Unicode;
using Fluid;
using Fluid.Values;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>A template of a page. Values are inserted as text, and as HTML only where the template says so.</summary>
/// <param name="name">The name of its resource.</param>
/// <param name="words">The texts that it refers to by name.</param>
internal sealed class PageTemplate(string name, IReadOnlyDictionary<string, Word> words)
{
    // letters of all languages as they are; characters special in HTML are escaped
    private static readonly HtmlEncoder Encoder = HtmlEncoder.Create(UnicodeRanges.All);

    private readonly Lazy<IFluidTemplate> _template = new(() => new FluidParser().Parse(Resource(name)));
    private readonly TemplateOptions _options = NewOptions(words);

    /// <summary>The page with these values.</summary>
    public string Render(params IEnumerable<(string Name, object Value)> values)
    {
        TemplateContext context = new(new Dictionary<string, object>(), _options);
        foreach ((string name, object value) in values)
            context.SetValue(name, value);

        return _template.Value.Render(context, Encoder);
    }

    /// <summary>A resource of the program: a template, a style or a script.</summary>
    public static string Resource(string name) => Text(typeof(PageTemplate).Assembly, "report/" + name);

    /// <summary>A text resource of an assembly.</summary>
    public static string Text(Assembly assembly, string name)
    {
        using StreamReader reader = new(assembly.GetManifestResourceStream(name) ?? throw new InvalidOperationException($"no resource {name}"));
        return reader.ReadToEnd();
    }

    private static TemplateOptions NewOptions(IReadOnlyDictionary<string, Word> words)
    {
        TemplateOptions options = new()
        {
            MemberAccessStrategy = new UnsafeMemberAccessStrategy { MemberNameStrategy = MemberNameStrategies.CamelCase },
        };
        options.Filters.AddFilter("word", (input, arguments, _) =>
        {
            Word word = input.ToObjectValue() as Word ?? words[input.ToStringValue()];
            return new StringValue(InBoth(arguments.Count == 0 ? word : word.With([.. arguments.Values.Select(value => value.ToObjectValue())])), encode: false);
        });
        // the description of a scene is translated where the scene is one of ours
        options.Filters.AddFilter("said", (input, _, _) => new StringValue(InBoth(Words.Said(input.ToStringValue())), encode: false));
        options.Filters.AddFilter("plain", (input, _, _) => new StringValue(((Word)input.ToObjectValue()).In(Language.IsChinese)));
        // the reader of a page that was asked for in Chinese need not look for the button, not even where there is no JavaScript
        options.Filters.AddFilter("language", (_, _, _) => new StringValue(Language.IsChinese ? "zh" : "en"));
        return options;
    }

    /// <summary>A text in both languages, of which the style shows one.</summary>
    private static string InBoth(Word word) => word.En == word.Zh
        ? $"<bdi>{Encoder.Encode(word.En)}</bdi>"
        : $"<span lang=\"en\">{Encoder.Encode(word.En)}</span><span lang=\"zh\">{Encoder.Encode(word.Zh)}</span>";
}
