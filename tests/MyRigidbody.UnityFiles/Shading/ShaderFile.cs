using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.UnityFiles.Shading;

/// <summary>A .shader: its blocks, commands and programs. Only what Unity's ShaderLab and our shaders have in common is known.</summary>
public sealed partial class ShaderFile
{
    private readonly string _text;
    private int _at;

    private ShaderFile(string text)
    {
        _text = text;
        ShaderPart shader = Part();
        if (shader.Word != "Shader" || shader.Values.Count != 1 || Next() is not null)
            throw Wrong("must be one Shader \"NAME\" { … }");

        Root = shader;
    }

    /// <summary>The shader itself: its name is its only value, and all else is in it.</summary>
    public ShaderPart Root { get; }

    /// <summary>Its name, by which a project finds it.</summary>
    public string Name => Root.Values[0];

    /// <summary>Reads the text of a file.</summary>
    /// <exception cref="FormatException">It is not balanced, or is no shader; the message says in which line.</exception>
    public static ShaderFile Parse(string text) => new(text);

    /// <summary>The number that a constant of the programs is set to: <c>static const float NAME = …;</c>.</summary>
    public float Constant(string name) => Constants(name, "float")[0];

    /// <summary>The three numbers that a constant of the programs is set to: <c>static const float3 NAME = float3(…);</c>.</summary>
    public System.Numerics.Vector3 Direction(string name) => new(Constants(name, "float3"));

    private float[] Constants(string name, string type)
    {
        Match found = Regex.Match(_text, $@"static const {type} {name} = (?:{type}\()?([-0-9., ]+)\)?;");
        return found.Success
            ? [.. found.Groups[1].Value.Split(',').Select(number => float.Parse(number, CultureInfo.InvariantCulture))]
            : throw new FormatException($"has no line 'static const {type} {name} = …;'");
    }

    // a word, the values after it on the line, and what stands in braces
    private ShaderPart Part()
    {
        int line = Line();
        string word = Take();
        if (word is "CGINCLUDE" or "CGPROGRAM")
            return new ShaderPart(word, line, [], [], Program());

        List<string> values = [];
        while (Next() is string next && next != "}" && (next == "{" || Line() == line))
        {
            if (next != "{")
                values.Add(Take().Trim('"'));
            else if (word == "Tags" || values.Contains("="))
                values.AddRange(Braces().Select(inner => inner.Trim('"')));
            else
                return new ShaderPart(word, line, values, Parts(), null);
        }

        return new ShaderPart(word, line, values, [], null);
    }

    private List<ShaderPart> Parts()
    {
        Take();
        List<ShaderPart> parts = [];
        while (Next() != "}")
            parts.Add(Next() == null ? throw Wrong("a brace is not closed") : Part());

        Take();
        return parts;
    }

    private List<string> Braces()
    {
        Take();
        List<string> inner = [];
        while (Next() != "}")
            inner.Add(Take());

        Take();
        return inner;
    }

    private string Program()
    {
        int end = _text.IndexOf("ENDCG", _at, StringComparison.Ordinal);
        if (end < 0)
            throw Wrong("a program has no ENDCG");

        string program = Comment().Replace(_text[_at..end], string.Empty);
        _at = end + "ENDCG".Length;
        return program;
    }

    private int Line() => 1 + _text.AsSpan(0, Token().Index).Count('\n');

    private string? Next() => Token() is { Length: > 0 } token ? token.Value : null;

    private string Take()
    {
        string token = Next() ?? throw Wrong("ends too early");
        _at = Token().Index + token.Length;
        return token;
    }

    private Match Token()
    {
        _at += Blank().Match(_text, _at).Length;
        return Word().Match(_text, _at);
    }

    private FormatException Wrong(string what) => new($"line {1 + _text.AsSpan(0, _at).Count('\n')}: {what}");

    [GeneratedRegex(@"\G(\s|//[^\n]*)*")]
    private static partial Regex Blank();

    [GeneratedRegex(@"\G(""[^""\n]*""|[\w.]+|[^\s])?")]
    private static partial Regex Word();

    [GeneratedRegex(@"//[^\n]*")]
    private static partial Regex Comment();
}

/// <summary>A block or a command of a shader.</summary>
/// <param name="Word">What it begins with: SubShader, Pass, Tags, ColorMask.</param>
/// <param name="Line">In which line.</param>
/// <param name="Values">What follows it, without quotation marks.</param>
/// <param name="Parts">What stands in its braces.</param>
/// <param name="Program">The program, where it is one.</param>
public sealed record ShaderPart(string Word, int Line, IReadOnlyList<string> Values, IReadOnlyList<ShaderPart> Parts, string? Program)
{
    /// <summary>The parts in it that begin with a word.</summary>
    public IEnumerable<ShaderPart> All(string word) => Parts.Where(part => part.Word == word);

    public IReadOnlyDictionary<string, string> Tags => All("Tags").SelectMany(tags => tags.Values.Chunk(3))
        .ToDictionary(tag => tag[0], tag => tag.Length == 3 && tag[1] == "=" ? tag[2] : throw new FormatException($"tag {tag[0]} has no value"));
}
