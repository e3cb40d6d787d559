using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>Unique file names that every file system accepts and that name the student.</summary>
internal static class PageNames
{
    private const int Longest = 60;

    private static readonly string[] Devices =
        ["CON", "PRN", "AUX", "NUL", .. Enumerable.Range(0, 10).SelectMany(i => new[] { $"COM{i}", $"LPT{i}" })];

    /// <summary>A name for every submission.</summary>
    public static IReadOnlyList<string> Of(IEnumerable<Graded> submissions)
    {
        HashSet<string> taken = new(StringComparer.OrdinalIgnoreCase);
        return [.. submissions.Select(one => Unique(Safe(one.Student is { } student ? $"{student.Id}_{student.Name}".Trim('_') : Path.GetFileNameWithoutExtension(one.Submission.Spot.Name)), taken) + ".html")];
    }

    /// <summary>A text as a part of a file's name.</summary>
    internal static string Safe(string text)
    {
        // letters and digits of all languages, 〇 too; combining marks could make two names equal on some systems
        StringBuilder safe = new();
        foreach (Rune rune in text.EnumerateRunes().Take(Longest))
            safe.Append(Rune.IsLetterOrDigit(rune) || Rune.GetUnicodeCategory(rune) == UnicodeCategory.LetterNumber ? rune.ToString() : rune.Value is '-' or '_' ? rune.ToString() : "_");

        string name = safe.ToString().Trim('_');
        return name.Length == 0 ? "student" : Devices.Contains(name, StringComparer.OrdinalIgnoreCase) ? "_" + name : name;
    }

    private static string Unique(string name, HashSet<string> taken)
    {
        string unique = name;
        for (int i = 2; !taken.Add(unique); i++)
            unique = $"{name}-{i}";

        return unique;
    }
}
