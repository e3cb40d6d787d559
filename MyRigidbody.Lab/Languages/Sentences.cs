using System.Reflection;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>
/// What the program says, in English and below it in Chinese, as the files *.zh.txt beside this one have it. {0} is a number, a name or a
/// file and stays as it is; {a} is a part of the sentence that is looked for in its turn.
/// </summary>
internal static partial class Sentences
{
    private const string Suffix = ".zh.txt", Prefix = "languages/";

    // what is longer is no sentence of ours, and would be searched for long
    private const int Longest = 2000;

    // letters around the holes
    private const int Telling = 10;

    // behind this stands a value of the user's, which is no part of a sentence
    private const string Found = ", found ", InBody = ", in body ";

    private static readonly Lazy<Dictionary<string, string>> Fixed = new(() => Read().Where(pair => !Hole().IsMatch(pair.English)).ToDictionary(pair => pair.English, pair => pair.Chinese));

    // where two fit, the one that says more of itself
    private static readonly Lazy<Template[]> WithHoles = new(() => [.. Read().Where(pair => Hole().IsMatch(pair.English))
        .Select(pair => new Template(pair.English, pair.Chinese)).OrderByDescending(template => template.Says(Found)).ThenByDescending(template => template.Letters)]);

    /// <summary>A text in Chinese, line by line; what is not known stays as it is.</summary>
    public static string InChinese(string english) => string.Join('\n', english.Split('\n').Select(Line));

    /// <summary>All sentences that are known.</summary>
    public static IEnumerable<(string English, string Chinese)> Read()
    {
        Assembly own = typeof(Sentences).Assembly;
        foreach (string name in own.GetManifestResourceNames().Where(name => name.StartsWith(Prefix, StringComparison.Ordinal) && name.EndsWith(Suffix, StringComparison.Ordinal)))
        {
            using StreamReader reader = new(own.GetManifestResourceStream(name)!);
            string[] lines = [.. reader.ReadToEnd().Split('\n').Select(line => line.TrimEnd('\r')).Where(line => line.Length > 0 && line[0] != '#')];
            for (int i = 0; i + 1 < lines.Length; i += 2)
                yield return (lines[i], lines[i + 1]);
        }
    }

    private static string Line(string line)
    {
        string text = line.Trim();
        int indent = line.Length - line.TrimStart().Length;
        return text.Length is 0 or > Longest ? line : line[..indent] + Text(text) + line[(indent + text.Length)..];
    }

    private static string Text(string english)
    {
        if (Fixed.Value.TryGetValue(english, out string? whole))
            return whole;

        // a file and a place stand before what is said of them; what says little of itself fits too much
        return Fitting(english, template => template.Letters >= Telling && (template.Says(Found) || template.Says(InBody) || !english.Contains(Found, StringComparison.Ordinal))) ?? AfterPlace(english) ?? Fitting(english, _ => true) ?? Words.Phrase(english).Zh;
    }

    private static string? Fitting(string english, Func<Template, bool> tried)
    {
        foreach (Template template in WithHoles.Value.Where(tried))
        {
            if (template.Pattern.Match(english) is { Success: true } match)
                return Hole().Replace(template.Chinese, hole => Filled(hole.Groups[1].Value, match.Groups["h" + hole.Groups[1].Value].Value));
        }

        return null;
    }

    private static string? AfterPlace(string english)
    {
        int colon = english.IndexOf(": ", StringComparison.Ordinal);
        string said = colon > 0 ? english[(colon + 2)..] : string.Empty, chinese = Line(said);
        return chinese != said ? Place(english[..colon]) + ": " + chinese : null;
    }

    // an argument of the library that is no name
    private static string Place(string place) => place.Contains(' ') ? Fixed.Value.GetValueOrDefault(place, place) : place;

    private static string Filled(string hole, string part) => char.IsAsciiDigit(hole[0]) || part.Length == 0 ? part : Line(part);

    [GeneratedRegex(@"\{([0-9a-z])\}")]
    private static partial Regex Hole();

    private sealed record Template(string English, string Chinese)
    {
        public bool Says(string words) => English.Contains(words, StringComparison.Ordinal);

        public int Letters { get; } = Hole().Replace(English, string.Empty).Length;

        public Regex Pattern { get; } = new(
            "^" + Hole().Replace(Regex.Escape(English).Replace(@"\{", "{", StringComparison.Ordinal), hole => $"(?<h{hole.Groups[1].Value}>.{(char.IsAsciiDigit(hole.Groups[1].Value[0]) ? '+' : '*')}?)") + "$",
            RegexOptions.CultureInvariant);
    }
}
