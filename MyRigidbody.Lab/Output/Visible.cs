using System.Buffers;
using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>
/// Texts of others, names and paths, as a person may see them: what would move the cursor, end the line or turn the direction
/// of reading is shown as its number in UTF-16, <c>\u001b</c>, and not sent. Everything that is printed passes here.
/// </summary>
internal static class Visible
{
    private static readonly SearchValues<char> Plain = SearchValues.Create([.. Enumerable.Range(' ', '~' - ' ' + 1).Select(code => (char)code)]);

    /// <summary>A text that stays in one line.</summary>
    public static string Line(string text) => Shown(text, string.Empty);

    /// <summary>The same with no more than so many characters of it.</summary>
    public static string Line(string text, int most) => text.Length <= most ? Line(text) : Line(text[..most]) + "…";

    /// <summary>A text in JSON, which goes on to mean the same; its own lines stay.</summary>
    public static string Json(string json) => Shown(json, "\r\n");

    private static string Shown(string text, string keep)
    {
        if (!text.AsSpan().ContainsAnyExcept(Plain))
        {
            return text;
        }

        StringBuilder shown = new(text.Length + 16);
        for (int at = 0, length; at < text.Length; at += length)
        {
            bool isWhole = Rune.DecodeFromUtf16(text.AsSpan(at), out Rune rune, out length) == OperationStatus.Done;
            ReadOnlySpan<char> letter = text.AsSpan(at, length);
            if (isWhole && (!IsHidden(rune) || keep.Contains(letter[0])))
            {
                shown.Append(letter);
                continue;
            }

            foreach (char unit in letter)
            {
                shown.Append(CultureInfo.InvariantCulture, $"\\u{(int)unit:x4}");
            }
        }

        return shown.ToString();
    }

    private static bool IsHidden(Rune rune) => Rune.GetUnicodeCategory(rune) switch
    {
        UnicodeCategory.Control or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator => true,
        // those that join or part letters belong to Persian, to Indic scripts and to emoji
        UnicodeCategory.Format => rune.Value is not ('\u200C' or '\u200D'),
        _ => false,
    };
}
