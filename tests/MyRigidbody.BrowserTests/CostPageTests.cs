using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The diagram of accuracy against time, and the advice that follows the line.</summary>
public sealed class CostPageTests : BrowserFixture
{
    private const double SameCost = 1.03;
    private TemporaryFolder _folder = null!;

    [OneTimeSetUp]
    public void Open()
    {
        _folder = new TemporaryFolder();
        Browser.Open(Pages.Cost(_folder));
    }

    [OneTimeTearDown]
    public void Stop() => _folder?.Dispose();

    [TestCase(-1)]
    [TestCase(-3)]
    [TestCase(-6)]
    [TestCase(-15)]
    public void Advice_follows_the_slider_and_is_that_of_the_terminal(int exponent)
    {
        Browser.Do($"const s = document.getElementById('wanted-0'); s.value = {exponent}; s.dispatchEvent(new Event('input'))");
        string answer = Browser.Find("#answer-0").Text;
        string? best = Cheapest(Math.Pow(10, exponent));

        Assert.That(answer, Does.StartWith($"Below 1e{exponent}: "));
        Assert.That(answer, best == null ? Does.Contain("none of these") : Does.Contain($": {best} in steps of "));
    }

    /// <summary>By cost.csv: of the integrators below an error, the first whose cost equals the least, within the uncertainty of the clock.</summary>
    private string? Cheapest(double error)
    {
        (string Rule, double Error, double Cost)[] below = [.. File.ReadLines(_folder.File("out/cost.csv")).Skip(1)
            .Select(line => line.Split(','))
            .Select(cells => (cells[1], Math.Max(Number(cells[5]), Number(cells[6])), Number(cells[10])))
            .Where(trial => trial.Item2 < error)];
        return below.FirstOrDefault(trial => trial.Cost <= SameCost * below.Min(other => other.Cost)).Rule;

        static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
    }

    [Test]
    public void Line_that_is_dragged_moves_the_slider()
    {
        Browser.Do("Plotly.relayout(document.getElementById('diagram-0'), { 'shapes[0].y0': 1e-4, 'shapes[0].y1': 1e-4 })");
        Thread.Sleep(300);

        Assert.That(Browser.Get<double>("document.getElementById('wanted-0').valueAsNumber"), Is.EqualTo(-4));
        Assert.That(Browser.Find("#answer-0").Text, Does.StartWith("Below 1e-4: "));
    }

    [Test]
    public void Chinese_is_spoken_in_the_diagram_too()
    {
        Browser.Do("document.getElementById('language').click()");
        Assert.That(Browser.Find("#answer-0").Text, Does.Contain("低于"));
        Assert.That(Browser.Get<string>("document.getElementById('diagram-0').textContent"), Does.Contain("最大误差"));
        Browser.Do("document.getElementById('language').click()");
    }
}
