using System.Buffers;
using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>
/// Makes foreign texts, names and paths safe to print: characters that would move the cursor, end the line or change the writing
/// direction are shown as their number in UTF-16, <c>\u001b</c>. Everything that is printed passes here.
/// </summary>
internal static class Visible
{
    private static readonly SearchValues<char> Plain = SearchValues.Create([.. Enumerable.Range(' ', '~' - ' ' + 1).Select(code => (char)code)]);

    public static string Line(string text) => Shown(text, string.Empty);

    /// <summary>The same, cut after a number of characters.</summary>
    public static string Line(string text, int most) => text.Length <= most ? Line(text) : Line(text[..most]) + "…";

    /// <summary>A text in JSON with the same meaning; its line breaks stay.</summary>
    public static string Json(string json) => Shown(json, "\r\n");

    private static string Shown(string text, string keep)
    {
        if (!text.AsSpan().ContainsAnyExcept(Plain))
            return text;

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
                shown.Append(CultureInfo.InvariantCulture, $"\\u{(int)unit:x4}");
        }

        return shown.ToString();
    }

    private static bool IsHidden(Rune rune) => Rune.GetUnicodeCategory(rune) switch
    {
        UnicodeCategory.Control or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator => true,
        // zero-width joiners belong to Persian, to Indic scripts and to emoji
        UnicodeCategory.Format => rune.Value is not ('\u200C' or '\u200D'),
        _ => false,
    };
}
