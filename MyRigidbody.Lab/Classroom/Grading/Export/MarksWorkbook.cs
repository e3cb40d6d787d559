using System.Drawing;
using System.IO.Compression;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Output;
using SpreadCheetah;
using SpreadCheetah.Styling;
using SpreadCheetah.Worksheets;

namespace RigidBodyDynamics.Lab.Grading.Export;

/// <summary>The marks as a workbook: a sheet of marks, and one with every finding. Texts are cells of texts, never formulas.</summary>
internal static class MarksWorkbook
{
    private const int LongestCell = 2000;

    // the earliest time that a zip can store
    private static readonly DateTimeOffset NoTime = new(1980, 1, 1, 0, 0, 0, TimeSpan.Zero);

    private static readonly string[] FindingHeadings =
        ["学号 id", "姓名 name", "部分 part", "代码 code", "待定 doubtful", "行 line", "应为 expected", "实为 found", "说明", "about", "文件 file"];

    private static readonly double[] MarkWidths = [14, 12, 9, 11, 11, 11, 11, 11, 9, 9, 9, 12, 18, 60, 40], FindingWidths = [14, 12, 15, 24, 9, 6, 36, 36, 60, 60, 40];

    /// <summary>The file, of the same bytes for the same class.</summary>
    public static byte[] Of(Class all)
    {
        MemoryStream written = new();
        Write(all, written).GetAwaiter().GetResult();
        return WithoutTimes(written);
    }

    private static async Task Write(Class all, Stream stream)
    {
        await using Spreadsheet book = await Spreadsheet.CreateNewAsync(stream, new SpreadCheetahOptions { DocumentProperties = null });
        Styles styles = new(book);
        await Sheet(book, styles, "分数 marks", MarksTable.Headings, MarkWidths, MarksTable.Rows(all));
        await Sheet(book, styles, "发现 findings", FindingHeadings, FindingWidths, [.. all.Submissions.SelectMany(Findings)]);
        await book.FinishAsync();
    }

    private static async Task Sheet(Spreadsheet book, Styles styles, string name, IReadOnlyList<string> headings, double[] widths, IReadOnlyList<object[]> rows)
    {
        WorksheetOptions options = new() { FrozenRows = 1, FrozenColumns = 2, AutoFilter = new AutoFilterOptions($"A1:{(char)('A' + headings.Count - 1)}{rows.Count + 1}") };
        for (int column = 0; column < widths.Length; column++)
            options.Column(column + 1).Width = widths[column];

        await book.StartWorksheetAsync(name, options);
        await book.AddHeaderRowAsync([.. headings], styles.Heading);
        foreach (object[] row in rows)
            await book.AddRowAsync((IList<Cell>)[.. row.Select(styles.CellOf)]);
    }

    private static IEnumerable<object[]> Findings(Graded one) => one.Judgement.Verdict.Findings.Concat(one.Submission.Notes).Select(finding => new object[]
    {
        one.Student?.Id ?? string.Empty,
        one.Student?.Name ?? string.Empty,
        MarksFile.NameOf(finding.Step),
        finding.Code,
        finding.IsDoubtful ? "doubtful" : string.Empty,
        finding.Line is int line ? (double)line : string.Empty,
        finding.Expected,
        finding.Found,
        finding.Chinese,
        finding.English,
        one.File,
    });

    /// <summary>The entries of a zip have times; all are set to the same one.</summary>
    private static byte[] WithoutTimes(MemoryStream written)
    {
        MemoryStream bytes = new();
        written.Position = 0;
        using (ZipArchive from = new(written, ZipArchiveMode.Read))
        using (ZipArchive to = new(bytes, ZipArchiveMode.Create, leaveOpen: true))
        {
            foreach (ZipArchiveEntry entry in from.Entries)
            {
                ZipArchiveEntry copy = to.CreateEntry(entry.FullName, CompressionLevel.Optimal);
                copy.LastWriteTime = NoTime;
                using Stream content = entry.Open(), target = copy.Open();
                content.CopyTo(target);
            }
        }

        return bytes.ToArray();
    }

    private sealed class Styles(Spreadsheet book)
    {
        private readonly Dictionary<string, StyleId> _marks = new()
        {
            [MarksFile.NameOf(Mark.Right)] = book.AddStyle(Filled(Color.FromArgb(0xdf, 0xf2, 0xe1))),
            [MarksFile.NameOf(Mark.Wrong)] = book.AddStyle(Filled(Color.FromArgb(0xfb, 0xdd, 0xda))),
            [MarksFile.NameOf(Mark.Doubtful)] = book.AddStyle(Filled(Color.FromArgb(0xff, 0xef, 0xc2))),
            [MarksFile.NameOf(Mark.Missing)] = book.AddStyle(Filled(Color.FromArgb(0xe4, 0xe6, 0xe4))),
        };

        public StyleId Heading { get; } = book.AddStyle(new Style { Font = new Font { Bold = true }, Alignment = new Alignment { WrapText = true } });

        public Cell CellOf(object value) => value is double number ? new Cell(number) : new Cell(Visible.Line((string)value, LongestCell), _marks.GetValueOrDefault((string)value));

        private static Style Filled(Color color) => new() { Fill = new Fill { Color = color } };
    }
}
