using NUnit.Framework;
using RigidBodyDynamics.Figures;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>How pages are held to what cost and bench measure; that they are is a check of .ci/run, because no test takes time.</summary>
public sealed class FiguresTests
{
    private const string Text = """
        Before.

        <!-- figures: speeds -->
        | what | ns | off |
        | --- | ---: | ---: |
        | a | 10 | 2e-6 |
        | b | 1,200 | 3.0 |
        | c | `Exact` 1 s: 0.50 (3.1) | – |
        <!-- end -->

        After.

        """;

    [Test]
    public void Times_may_be_a_steady_factor_off_and_a_little_of_their_own() =>
        Assert.That(Differences(["a", "31", "2e-6"], ["b", "3,500", "3.0"], ["c", "`Exact4` 2 s: 1.9 (9.9)", "–"]), Is.Empty);

    [Test]
    public void Time_that_parts_by_more_than_noise_is_found() =>
        Assert.That(
            Differences(["a", "10", "2e-6"], ["b", "2,500", "3.0"], ["c", "`Exact` 1 s: 0.50 (3.1)", "–"]),
            Is.EqualTo(new[] { "speeds, b: 1,200 on the page, 2,500 measured, in a run 1.00 times as slow" }));

    [TestCase("a", "10", "3e-6", "2e-6 on the page")]
    [TestCase("z", "10", "2e-6", "a on the page")]
    [TestCase("a", "–", "2e-6", "10 on the page")]
    public void Error_name_or_dash_that_differs_is_found(string name, string time, string error, string finding) =>
        Assert.That(
            Differences([name, time, error], ["b", "1,200", "3.0"], ["c", "`Exact` 1 s: 0.50 (3.1)", "–"]),
            Has.Exactly(1).Items.And.One.Contains(finding));

    [Test]
    public void Missing_rows_and_cells_are_found()
    {
        Assert.That(Differences(["a", "10", "2e-6"]), Is.EqualTo(new[] { "speeds: 3 rows on the page, 1 measured" }));
        Assert.That(Differences(["a", "10"], ["b", "1,200", "3.0"], ["c", "`Exact` 1 s: 0.50 (3.1)", "–"]), Has.One.Contains("3 cells on the page, 2 measured"));
        Assert.That(() => Page.Differences(Text, _ => null).ToList(), Throws.InstanceOf<InvalidDataException>().With.Message.Contains("\"speeds\""));
    }

    [Test]
    public void What_is_written_is_there_and_nothing_else_has_changed()
    {
        IReadOnlyList<string[]> rows = [["d", "7", "1.0"]];

        string written = Page.Written(Text, _ => rows);

        Assert.That(written, Is.EqualTo(Text[..Text.IndexOf("| a |", StringComparison.Ordinal)] + "| d | 7 | 1.0 |\n" + Text[Text.IndexOf("<!-- end", StringComparison.Ordinal)..]));
        Assert.That(Page.Differences(written, _ => rows), Is.Empty);
    }

    [TestCase("README.md", 3)]
    [TestCase("README.zh.md", 3)]
    [TestCase("docs/accuracy.md", 1)]
    [TestCase("docs/accuracy.zh.md", 1)]
    public void Tables_of_measured_times_are_such_tables(string page, int tables) =>
        Assert.That(Page.Count(Tree.Text(page)), Is.EqualTo(tables));

    private static List<string> Differences(params string[][] rows) => [.. Page.Differences(Text, _ => rows)];
}
