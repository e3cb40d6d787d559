using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>
/// Texts as cells of a CSV file: a row is one line, and no spreadsheet computes a name. Numbers are written as they are.
/// </summary>
internal static partial class Csv
{
    // those of full width are read as the others by spreadsheets in East Asia
    private const string BeginFormula = "=+-@＝＋－＠";

    /// <summary>
    /// A cell. Characters that nobody sees are shown as <c>\u001b</c>, and a name that a spreadsheet would compute gets an
    /// apostrophe before it, which spreadsheets take for "this is text".
    /// </summary>
    public static string Cell(string text)
    {
        string shown = Visible.Line(LooksShown().Replace(text, @"\u005c"));
        string cell = Computes(shown) ? "'" + shown : shown;
        return cell.AsSpan().ContainsAny(",;\"") ? "\"" + cell.Replace("\"", "\"\"") + "\"" : cell;
    }

    /// <summary>The text of a cell, which any reader of CSV has taken out of its quotes.</summary>
    public static string Text(string cell)
    {
        string shown = cell.StartsWith('\'') && Computes(cell[1..]) ? cell[1..] : cell;
        return Number().Replace(shown, number => ((char)ushort.Parse(number.ValueSpan[2..], NumberStyles.HexNumber, CultureInfo.InvariantCulture)).ToString());
    }

    /// <summary>A plain number is no formula; a text that has such an apostrophe already gets one more, so that it can be taken away.</summary>
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
