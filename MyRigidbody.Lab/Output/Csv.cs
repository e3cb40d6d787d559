using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>
/// Texts as cells of a CSV file: a row is one line, and no name is taken for a formula. Numbers are written as they are.
/// </summary>
internal static partial class Csv
{
    // spreadsheets in East Asia read full-width characters like the others
    private const string BeginFormula = "=+-@＝＋－＠";

    /// <summary>
    /// A cell. Invisible characters are shown as <c>\u001b</c>, and a name that a spreadsheet would take for a formula gets an
    /// apostrophe before it, which marks a text.
    /// </summary>
    public static string Cell(string text)
    {
        string shown = Visible.Line(LooksShown().Replace(text, @"\u005c"));
        string cell = Computes(shown) ? "'" + shown : shown;
        return cell.AsSpan().ContainsAny(",;\"") ? "\"" + cell.Replace("\"", "\"\"") + "\"" : cell;
    }

    /// <summary>The text of a cell whose quotes a CSV reader has removed.</summary>
    public static string Text(string cell)
    {
        string shown = cell.StartsWith('\'') && Computes(cell[1..]) ? cell[1..] : cell;
        return Number().Replace(shown, number => ((char)ushort.Parse(number.ValueSpan[2..], NumberStyles.HexNumber, CultureInfo.InvariantCulture)).ToString());
    }

    /// <summary>False for a plain number; true for a text that begins with such an apostrophe, which gets one more so that one can be removed.</summary>
    private static bool Computes(string text)
    {
        string bare = text.TrimStart('\'');
        return bare.Length > 0 && BeginFormula.Contains(bare[0])
            && !(bare == text && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out _));
    }

    [GeneratedRegex(@"\\(?=u[0-9a-f]{4})")]
    private static partial Regex LooksShown();

    [GeneratedRegex(@"\\u[0-9a-f]{4}")]
    private static partial Regex Number();
}
