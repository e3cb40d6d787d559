using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>The page of cost holds what was measured: every trial, the tables of the terminal, and the same advice.</summary>
public sealed class CostPageTests
{
    private static readonly CostFindings Found = Measured();
    private static readonly Parsed Page = new(PageWriter.Html(Reports.Of([Found], "cost tumbling.json")));

    [Test]
    public void Diagram_has_every_trial_that_came_to_an_end()
    {
        JsonElement motion = Data().GetProperty("motions")[0];
        string[] rules = [.. Data().GetProperty("rules").EnumerateArray().Select(rule => rule.GetString()!)];
        (string, double, double)[] shown = [.. motion.GetProperty("trials").EnumerateArray()
            .Select(trial => (rules[trial[0].GetInt32()], trial[2].GetDouble(), trial[3].GetDouble()))];
        Trial[] expected = [.. Found.Trials.Where(trial => double.IsFinite(trial.Error))];

        Assert.That(shown.Select(trial => trial.Item1), Is.EqualTo(expected.Select(trial => trial.Rule.Name)));
        for (int i = 0; i < shown.Length; i++)
        {
            // six digits are written
            Assert.That(shown[i].Item2, Is.EqualTo(expected[i].Error).Within(5e-6 * expected[i].Error));
            Assert.That(shown[i].Item3, Is.EqualTo(expected[i].Cost).Within(5e-6 * expected[i].Cost));
        }
    }

    [Test]
    public void Table_has_a_row_for_every_integrator_and_a_heading_for_every_accuracy()
    {
        string[] rows = [.. Page.Document.QuerySelectorAll("#cost tbody th").Select(cell => cell.TextContent)];
        string headings = Page.Document.QuerySelector("#cost thead")!.TextContent;

        Assert.That(rows, Is.EqualTo(Rules.All.Select(rule => rule.Name)));
        foreach (string bound in new[] { "1e-3", "1e-6", "1e-9" })
            Assert.That(headings, Does.Contain($"to {bound}").And.Contain($"达到 {bound}"));
    }

    [Test]
    public void Page_says_how_it_was_made_and_fetches_nothing()
    {
        Assert.That(Page.Document.QuerySelector("#facts code")!.TextContent, Does.EndWith("-- cost tumbling.json"));
        Assert.That(Page.Document.QuerySelectorAll("[src], link[href]:not([href^='data:'])"), Is.Empty);
        Assert.That(System.Text.Encoding.UTF8.GetByteCount(Page.Html), Is.LessThan(5_000_000));
    }

    private static JsonElement Data() => JsonDocument.Parse(Page.Document.GetElementById("cost-data")!.TextContent).RootElement;

    private static CostFindings Measured() =>
        CostFindings.Of(SolvedMotion.Read("sym_top", SolvedMotion.All.Single(motion => motion.Name == "sym_top").Until), new Effort(3, 0.0001, 1), _ => { });
}
