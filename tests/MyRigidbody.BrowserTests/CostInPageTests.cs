using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Accuracy against time for the scene of the page, measured in the page.</summary>
public sealed class CostInPageTests : LabPageFixture
{
    private const string Ready = "window.report?.pictures?.() > 1 && document.getElementById('measure')?.textContent";
    private const string Done = "!document.getElementById('measure').hidden && document.getElementById('cost-said').textContent";

    [SetUp]
    public void Open()
    {
        Browser.Resize(1280, 900);
        Browser.Visit(Site.Address + "#lang=en&scene=tumbling-slab", Ready);
    }

    [Test]
    public void Scene_of_the_page_is_measured_drawn_and_listed_while_it_goes_on_playing()
    {
        Measure();
        int before = Browser.Get<int>("report.pictures()");
        Assert.That(Browser.Becomes("document.getElementById('measured').value > 0"), Is.True);
        Assert.That(Browser.Becomes($"report.pictures() > {before + 5}"), Is.True);
        Assert.That(Browser.Becomes(Done, 120), Is.True);
        Browser.Photograph("lab-cost");

        Assert.That(Browser.Find("#cost-scene").Text, Is.EqualTo("tumbling-slab"));
        Assert.That(Browser.Get<int>("document.querySelectorAll('#diagram-0 .scatterlayer .trace').length"), Is.AtLeast(10));
        Dictionary<string, double> errors = Column(1), times = Column(2);
        Assert.That(errors.Keys, Is.EqualTo(Rules.All.Select(rule => rule.Name)));
        Assert.That(times.Values, Is.All.GreaterThan(0));
        // the purpose of this page: the lab's integrator rotates a free body wrongly, and Exact does not, for a few times the cost
        Assert.That(errors["LabEuler"], Is.GreaterThan(0.1));
        Assert.That(errors["Exact"], Is.LessThan(1e-12)); // measured 3.1e-14
        Assert.That(times["Exact"], Is.LessThan(20 * times["LabEuler"]));
        Assert.That(Browser.Find("#cost-how").Text, Does.Contain("WebAssembly").And.Match("ticks every [0-9.]+ ms"));
    }

    [Test]
    public void Slider_finds_the_cheapest_in_both_languages_and_the_other_scene_is_said()
    {
        Measure();
        Assert.That(Browser.Becomes(Done, 120), Is.True);
        Browser.Do("const s = document.getElementById('wanted-0'); s.value = -6; s.dispatchEvent(new Event('input'))");
        Assert.That(Browser.Find("#answer-0").Text, Does.StartWith("Below 1e-6: Exact"));

        Browser.Find("#language").Click();
        Assert.That(Browser.Find("#answer-0").Text, Does.StartWith("低于 1e-6"));
        Assert.That(Browser.Find("#costs-0").Text, Does.Contain("步长"));
        Browser.Find("#language").Click();
        Browser.Do("lab.set({ scene: 'hammer', sceneText: undefined })");

        Assert.That(Browser.Becomes("document.getElementById('cost-said').textContent.includes('another motion')"), Is.True);
    }

    [Test]
    public void A_measurement_can_be_stopped_and_begun_again()
    {
        Measure();
        Assert.That(Browser.Becomes("document.getElementById('measured').value > 0"), Is.True);
        Browser.Find("#stop-measuring").Click();

        Assert.That(Browser.Find("#cost-said").Text, Is.EqualTo("Stopped."));
        Assert.That(Browser.Find("#measure").Displayed, Is.True);
        Measure();
        Assert.That(Browser.Becomes("document.getElementById('measured').value > 0"), Is.True);
        Browser.Find("#stop-measuring").Click();
    }

    [Test]
    public void A_scene_without_a_true_motion_says_why_in_one_line()
    {
        const string Scene = """
            { "schema": "rigid-body-scene/1", "name": "given", "step": 0.1, "steps": 2, "bodies": [{ "name": "b", "inertia": { "principal": [1, 2, 3] },
              "effects": [{ "perStep": { "force": [[1, 0, 0], [0, 1, 0]] } }] }] }
            """;
        Browser.Do($"lab.set({{ scene: 'given', sceneText: {System.Text.Json.JsonSerializer.Serialize(Scene)} }})");
        Assert.That(Browser.Becomes("document.getElementById('scene').value === 'given'"), Is.True, Browser.Find("#said").Text);
        Measure();

        Assert.That(Browser.Becomes(Done, 60), Is.True);
        Assert.That(Browser.Find("#cost-said").Text, Does.StartWith("This scene cannot be measured. given.json: bodies[0].effects[0]").And.Contain("step by step"));
    }

    private void Measure() => Browser.Do("document.getElementById('measure').scrollIntoView(); document.getElementById('measure').click()");

    private Dictionary<string, double> Column(int cell) => Browser
        .Get<string>($"[...document.querySelectorAll('#cost-rows tr')].map(row => row.cells[0].textContent + ' ' + row.cells[{cell}].textContent).join('\\n')")
        .Split('\n').Select(line => line.Split(' ')).ToDictionary(words => words[0], words => double.Parse(words[1], CultureInfo.InvariantCulture));
}
