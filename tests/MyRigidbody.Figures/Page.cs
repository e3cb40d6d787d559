using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Figures;

/// <summary>A page with tables between "figures: NAME" and "end", each with a head of two lines that stays as it is.</summary>
internal static partial class Page
{
    // other machines have other ratios, and this one is not always quiet
    private const double Noise = 2;

    /// <summary>The page with the tables that were measured.</summary>
    public static string Written(string text, Func<string, IReadOnlyList<string[]>?> measured) => Table().Replace(text, table =>
        table.Groups["head"].Value + string.Concat(Rows(table, measured).Select(cells => "| " + string.Join(" | ", cells) + " |\n")) + table.Groups["end"].Value);

    /// <summary>The differences between the page and the measurement: a word, an error, or a time by more than noise.</summary>
    public static IEnumerable<string> Differences(string text, Func<string, IReadOnlyList<string[]>?> measured)
    {
        foreach (Match table in Table().Matches(text))
        {
            string name = table.Groups["name"].Value;
            string[][] shown = [.. table.Groups["rows"].Value.Split('\n', StringSplitOptions.RemoveEmptyEntries)
                .Select(line => line.Trim('|', ' ').Split('|', StringSplitOptions.TrimEntries))];
            IReadOnlyList<string[]> found = Rows(table, measured);
            if (shown.Length != found.Count)
                yield return $"{name}: {shown.Length} rows on the page, {found.Count} measured";

            // a slower machine is slower at everything, so times are compared relative to most of the table
            double[] ratios = [.. shown.Zip(found).SelectMany(rows => rows.First.Zip(rows.Second)).Select(cells => Time(cells.First) / Time(cells.Second)).Where(double.IsFinite).Order()];
            double speed = ratios.Length > 0 ? ratios[ratios.Length / 2] : 1;
            foreach ((string[] page, string[] now) in shown.Zip(found))
            {
                if (page.Length != now.Length)
                    yield return $"{name}, {page[0]}: {page.Length} cells on the page, {now.Length} measured";

                foreach ((string here, string there) in page.Zip(now).Where(cells => cells.First != cells.Second))
                {
                    double ratio = Time(here) / Time(there);
                    // a cell that names an integrator and a step in addition may name another one of equal cost
                    if (!(ratio / speed < Noise && speed / ratio < Noise))
                        yield return string.Create(CultureInfo.InvariantCulture, $"{name}, {page[0]}: {here} on the page, {there} measured, in a run {1 / speed:0.00} times as slow");
                }
            }
        }
    }

    /// <summary>How many tables a page has.</summary>
    public static int Count(string text) => Table().Count(text);

    private static IReadOnlyList<string[]> Rows(Match table, Func<string, IReadOnlyList<string[]>?> measured) =>
        measured(table.Groups["name"].Value) ?? throw new InvalidDataException($"there is no table \"{table.Groups["name"].Value}\"");

    /// <summary>A time, bare or after a colon; errors have an exponent and must be equal as they stand.</summary>
    private static double Time(string cell) =>
        Number().Match(cell) is { Success: true } match ? double.Parse(match.Groups["time"].Value, NumberStyles.Number, CultureInfo.InvariantCulture) : double.NaN;

    [GeneratedRegex(@"(?<head><!-- figures: (?<name>[^\n]+) -->\n\|[^\n]*\n\|[^\n]*\n)(?<rows>(\|[^\n]*\n)*)(?<end><!-- end -->)")]
    private static partial Regex Table();

    [GeneratedRegex(@"^(`\w+` [\d.]+ s: )?(?<time>[\d.,]+)( \([\d.,]+\))?$")]
    private static partial Regex Number();
}
