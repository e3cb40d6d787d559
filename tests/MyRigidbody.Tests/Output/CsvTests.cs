using NUnit.Framework;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Tests.Output;

/// <summary>Texts as cells of a table that a spreadsheet may open.</summary>
public sealed class CsvTests
{
    [TestCase("MyRigidbody", "MyRigidbody")]
    [TestCase("a,b", "\"a,b\"")]
    [TestCase("say \"b\"", "\"say \"\"b\"\"\"")]
    [TestCase("a\nb", @"a\u000ab")]
    [TestCase("=1+1", "'=1+1")]
    [TestCase("+1+1", "'+1+1")]
    [TestCase("-1+1", "'-1+1")]
    [TestCase("@SUM(A1)", "'@SUM(A1)")]
    [TestCase("＝1+1", "'＝1+1")]
    [TestCase("=cmd|' /C calc'!A1", "'=cmd|' /C calc'!A1")]
    [TestCase("=HYPERLINK(\"http://x\",\"y\")", "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"")]
    // where the list separator is a semicolon, what follows one would be a cell of its own
    [TestCase("a;=1+1", "\"a;=1+1\"")]
    // a line break cannot begin a cell
    [TestCase("\t=1+1", @"\u0009=1+1")]
    [TestCase("-5", "-5")]
    [TestCase("+1e-3", "+1e-3")]
    [TestCase("'tis", "'tis")]
    [TestCase("'=1", "''=1")]
    [TestCase("", "")]
    public void A_text_is_a_text_in_a_spreadsheet(string text, string cell) => Assert.That(Csv.Cell(text), Is.EqualTo(cell));

    [TestCase("plain")]
    [TestCase("a,\"b\";c")]
    [TestCase("=1+1")]
    [TestCase("'=1+1")]
    [TestCase("'''@x")]
    [TestCase("'-5")]
    [TestCase("-5")]
    [TestCase("'")]
    [TestCase("a\r\n\u001b\u202eb")]
    [TestCase(@"C:\u0041\u001b")]
    [TestCase("=\n\\u000a\n")]
    [TestCase("\U000E0041 刚体")]
    public void It_reads_back(string text) => Assert.That(Csv.Text(Unquoted(Csv.Cell(text))), Is.EqualTo(text));

    [Test]
    public void Any_text_at_all_reads_back_and_stays_in_its_cell()
    {
        Random random = new(1);
        const string Letters = "a'=+-@\\u001b0,;\"\n\r\t \u001b\u202e＝é";
        for (int i = 0; i < 100_000; i++)
        {
            string text = string.Concat(Enumerable.Range(0, random.Next(12)).Select(_ => Letters[random.Next(Letters.Length)]));

            string cell = Csv.Cell(text), bare = Unquoted(cell);

            Assert.That(Csv.Text(bare), Is.EqualTo(text));
            Assert.That(cell.AsSpan().IndexOfAny("\r\n\t\u001b\u202e"), Is.EqualTo(-1), text);
            Assert.That(bare.Length > 0 && "=+-@＝".Contains(bare[0]) && !double.TryParse(bare, out _), Is.False, text);
        }
    }

    private static string Unquoted(string cell) => cell.StartsWith('"') ? cell[1..^1].Replace("\"\"", "\"") : cell;
}
