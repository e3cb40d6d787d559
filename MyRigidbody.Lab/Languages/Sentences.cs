using System.Reflection;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>
/// The program's sentences, English and below it Chinese, from the files *.zh.txt beside this one. {0} is a number, a name or a
/// file and is not translated; {a} is a part of the sentence that is translated separately.
/// </summary>
internal static partial class Sentences
{
    private const string Suffix = ".zh.txt", Prefix = "languages/";

    // a longer text is not one of these sentences, and would be slow to search
    private const int Longest = 2000;

    // letters outside the holes
    private const int Telling = 10;

    // followed by a value of the user's, which is not translated
    private const string Found = ", found ", InBody = ", in body ";

    private const string InLine = "line ";

    private static readonly Lazy<Dictionary<string, string>> Fixed = new(() => Read().Where(pair => !Hole().IsMatch(pair.English)).ToDictionary(pair => pair.English, pair => pair.Chinese));

    // where two fit, the one with more letters of its own
    private static readonly Lazy<Template[]> WithHoles = new(() => [.. Read().Where(pair => Hole().IsMatch(pair.English))
        .Select(pair => new Template(pair.English, pair.Chinese)).OrderByDescending(template => template.Says(Found)).ThenByDescending(template => template.Letters)]);

    /// <summary>A text in Chinese, line by line; an unknown line stays English.</summary>
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

        // a file and a place come before the message; sentences with few letters of their own would fit too often
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
        return chinese == said ? null
            : english.StartsWith(InLine, StringComparison.Ordinal) ? Fitting(english[..colon], _ => true) + "：" + chinese
            : Place(english[..colon]) + ": " + chinese;
    }

    // an argument of the library that is not a name
    private static string Place(string place) => place.Contains(' ') ? Fixed.Value.GetValueOrDefault(place, place) : place;

    private static string Filled(string hole, string part) => char.IsAsciiDigit(hole[0]) || part.Length == 0 ? part : Line(part);

    [GeneratedRegex(@"\{([0-9a-z])\}")]
    private static partial Regex Hole();

    private sealed record Template(string English, string Chinese)
    {
        public bool Says(string words) => English.Contains(words, StringComparison.Ordinal);

        // a sentence that begins with a value has nothing before it: what stands before a colon is a place
        private static string NoPlace(string english) => english.StartsWith("{0} ", StringComparison.Ordinal) && char.IsAsciiLetterLower(english[4]) ? "(?!\\S+ \\(line|[^ ]+: |line [0-9])" : string.Empty;

        public int Letters { get; } = Hole().Replace(English, string.Empty).Length;

        public Regex Pattern { get; } = new(
            "^" + NoPlace(English) + Hole().Replace(Regex.Escape(English).Replace(@"\{", "{", StringComparison.Ordinal), hole => $"(?<h{hole.Groups[1].Value}>.{(char.IsAsciiDigit(hole.Groups[1].Value[0]) ? '+' : '*')}?)") + "$",
            RegexOptions.CultureInvariant);
    }
}
