using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The Play part of the lab: bodies that move while keys are held, and the saved motion.</summary>
public sealed class PlayPageTests : LabPageFixture
{
    private const string Moves = "window.report?.live?.() && report.time() > 0.1";

    private TemporaryFolder _folder = null!;

    [OneTimeSetUp]
    public void Start()
    {
        _folder = new TemporaryFolder();
    }

    [SetUp]
    public void Open()
    {
        Browser.Resize(1280, 900);
        Browser.Visit(Site.Address + "#lang=en&theme=light", Moves);
        Browser.Do("document.activeElement.blur()");
    }

    [OneTimeTearDown]
    public void Stop() => _folder?.Dispose();

    [Test]
    public void A_key_acts_in_the_step_after_it_went_down_and_ends_the_keys_of_the_file()
    {
        // the step that is next when the key goes down
        Browser.Do("const down = Event.prototype.preventDefault; Event.prototype.preventDefault = function () { window.next ??= report.live().steps; down.call(this); }");
        Key("keydown", "ArrowLeft");
        Assert.That(Browser.Becomes("report.live().felt.length > 0"), Is.True);
        Key("keyup", "ArrowLeft");

        Assert.That(Browser.Get<string>("report.live().felt[0].key"), Is.EqualTo("LeftArrow"));
        Assert.That(Browser.Get<int>("report.live().felt[0].step"), Is.EqualTo(Browser.Get<int>("window.next")));
        Assert.That(Browser.Get<bool>("document.getElementById('file-keys').checked"), Is.False);
        Assert.That(Browser.Becomes("report.live().felt.length === 2 && !document.querySelector('[data-key].on')"), Is.True);
    }

    [Test]
    public void A_tap_between_two_steps_acts_in_one()
    {
        Key("keydown", "ArrowUp");
        Key("keyup", "ArrowUp");

        Assert.That(Browser.Becomes("report.live().felt.length === 2"), Is.True);
        Assert.That(Browser.Get<int>("report.live().felt[1].step - report.live().felt[0].step"), Is.AtLeast(1));
    }

    [Test]
    public void Fingers_hold_several_buttons_at_once_and_let_them_go()
    {
        Finger("pointerdown", 7, "RightArrow");
        Finger("pointerdown", 8, "R");
        Assert.That(Browser.Becomes("['RightArrow', 'R'].every(key => report.live().felt.some(felt => felt.key === key && felt.isDown))"), Is.True);
        Assert.That(Browser.Get<string>("[...document.querySelectorAll('[data-key].on')].map(key => key.dataset.key).join()"), Does.Contain("RightArrow").And.Contain("R"));

        Finger("pointercancel", 7, "RightArrow");
        Finger("pointerup", 8, "R");
        Assert.That(Browser.Becomes("report.live().felt.filter(felt => !felt.isDown).length === 2"), Is.True);
    }

    [Test]
    public void Lost_focus_lets_keys_go()
    {
        Key("keydown", "ArrowDown");
        Assert.That(Browser.Becomes("report.live().felt.length === 1"), Is.True);

        Browser.Do("dispatchEvent(new Event('blur'))");

        Assert.That(Browser.Becomes("report.live().felt.length === 2 && !report.live().felt[1].isDown"), Is.True);
    }

    [Test]
    public void What_was_played_is_scrubbed_and_goes_on_where_it_ended()
    {
        Assert.That(Browser.Becomes("report.time() > 1"), Is.True);
        Browser.Find("#play").Click();
        double end = Browser.Get<double>("report.motion.end");
        string first = Browser.Get<string>("JSON.stringify(report.poseAt(0.5))");
        Browser.Do("const time = document.getElementById('time'); time.value = 0.5; time.dispatchEvent(new Event('input'))");

        Assert.That(Browser.Get<double>("report.time()"), Is.EqualTo(0.5));
        Assert.That(Browser.Get<double>("report.motion.end"), Is.EqualTo(end), "looking back makes nothing new");

        Browser.Find("#play").Click();
        Assert.That(Browser.Becomes($"report.motion.end > {end.ToString("R", CultureInfo.InvariantCulture)}"), Is.True);
        Assert.That(Browser.Get<string>("JSON.stringify(report.poseAt(0.5))"), Is.EqualTo(first));
    }

    [Test]
    public void One_step_on_is_one_step()
    {
        Browser.Find("#play").Click();
        Browser.Do("report.setTime(report.motion.end)");
        int steps = Browser.Get<int>("report.live().steps");

        Browser.Find("#on").Click();
        Assert.That(Browser.Becomes($"report.live().steps === {steps + 1} && report.time() === report.motion.end"), Is.True);

        Browser.Find("#back").Click();
        Assert.That(Browser.Get<double>("report.time() / 0.02"), Is.EqualTo(steps).Within(1e-9));
        Assert.That(Browser.Get<string>("document.getElementById('live').textContent"), Does.Contain("Paused at").And.Contain("DefaultRigidbody turns at"));
    }

    [TestCase("Exact", "lab-box")]
    [TestCase("RungeKutta4", "t-handle")]
    public void Scene_and_integrator_are_chosen(string rule, string scene)
    {
        Choose("scene", scene);
        Assert.That(Browser.Becomes($"lab.state.scene === '{scene}' && report.time() > 0"), Is.True);
        Choose("rule", rule);
        Assert.That(Browser.Becomes($"lab.state.rule === '{rule}' && report.time() > 0"), Is.True);

        Assert.That(Browser.Get<string>("lab.played().text"), Does.Contain($"\"integrator\": \"{rule}\""));
        Assert.That(Browser.Get<bool>("document.getElementById('said').hidden"), Is.True);
    }

    [Test]
    public void The_gallery_is_all_the_scenes_there_are()
    {
        string[] scenes = [.. Directory.GetFiles(Root.File("scenes"), "*.json").Select(Path.GetFileNameWithoutExtension).Where(name => !name!.Contains("schema", StringComparison.Ordinal))!];

        Assert.That(Browser.Get<string>("[...document.getElementById('scene').options].map(option => option.value).join()").Split(','), Is.EquivalentTo(scenes));
    }

    [Test]
    public void A_scene_that_is_none_is_refused_in_one_line_and_the_other_goes_on()
    {
        Browser.Do("lab.set({ scene: 'mine', sceneText: '{ \"schema\": \"rigid-body-scene/1\", \"name\": \"x\", \"step\": 0.02, \"duration\": 1, \"bodies\": [{ \"name\": \"a\", \"mass\": -1 }] }' })");

        Assert.That(Browser.Becomes("!document.getElementById('said').hidden"), Is.True);
        Assert.That(Browser.Get<string>("document.getElementById('said').textContent"), Does.StartWith("mine.json: bodies[0].mass: must be").And.EndsWith("in body \"a\""));
        Browser.Do("report.setLanguage('zh')");
        Assert.That(Browser.Get<string>("document.getElementById('said').textContent"), Does.StartWith("mine.json: bodies[0].mass").And.Match(@"\p{IsCJKUnifiedIdeographs}").And.Not.Contain("must"));
        Browser.Do("report.setLanguage('en')");
        double now = Browser.Get<double>("report.time()");
        Assert.That(Browser.Becomes($"report.time() > {now.ToString("R", CultureInfo.InvariantCulture)}"), Is.True);
    }

    [Test]
    public void Scene_and_recording_are_saved_and_the_command_line_reads_them()
    {
        Browser.SaveTo(_folder.Path);
        Key("keydown", "ArrowLeft");
        Assert.That(Browser.Becomes("report.live().felt.length > 0 && report.time() > 1"), Is.True);
        Key("keyup", "ArrowLeft");
        Browser.Find("#play").Click();
        int steps = Browser.Get<int>("report.live().steps");
        double end = Browser.Get<double>("report.data.bodies[0].position[report.data.bodies[0].position.length - 3]");
        Browser.Find("#save-scene").Click();
        Browser.Find("#save-recording").Click();
        foreach (string name in new[] { "lab-played.json", "lab-recording.json", "lab-recording.csv" })
            Assert.That(() => File.Exists(_folder.File(name)), NUnit.Framework.Is.True.After(20_000, 100), name);

        LabProcess run = LabProcess.Run(_folder.Path, "run", "lab-played.json", "--every", "0");
        LabProcess compare = LabProcess.Run(_folder.Path, "compare", "lab-recording.json");

        string[] last = run.Output.Split('\n').Single(line => line.StartsWith($"MyRigidbody,{steps},", StringComparison.Ordinal)).Split(',');
        Assert.That(double.Parse(last[3], CultureInfo.InvariantCulture), Is.EqualTo(end));
        Assert.That(compare.Output, Does.Contain("bit for bit"));
    }

    [Test]
    public void The_report_is_the_page_of_compare()
    {
        Browser.SaveTo(_folder.Path);
        Browser.Find("#play").Click();
        Browser.Find("#save-report").Click();
        string page = _folder.File("lab-played.html");

        Assert.That(() => File.Exists(page), NUnit.Framework.Is.True.After(120_000, 200));
        string html = File.ReadAllText(page);
        Assert.That(html, Does.Contain("compare lab-played.json").And.Contain("id=\"rules\"").And.Contain("report.poseAt"));
        Assert.That(Browser.Get<bool>("document.getElementById('said').hidden"), Is.True);
    }

    [Test]
    public void Curves_are_drawn_when_they_come_into_view_and_grow()
    {
        Assert.That(Browser.Get<bool>("window.Plotly === undefined"), Is.True);
        Browser.Do("document.getElementById('plots-part').open = true");

        Assert.That(Browser.Becomes("document.getElementById('curves').data?.length === 6"), Is.True);
        int points = Browser.Get<int>("document.getElementById('curves').data[0].x.length");
        Assert.That(Browser.Becomes($"document.getElementById('curves').data[0].x.length > {points}"), Is.True);
    }

    private void Key(string kind, string key) => Browser.Do($"dispatchEvent(new KeyboardEvent('{kind}', {{ key: '{key}', code: '{key}' }}))");

    private void Finger(string kind, int finger, string key) => Browser.Do(
        $"const key = document.querySelector('[data-key={key}]'); key.setPointerCapture = () => {{ }}; key.dispatchEvent(new PointerEvent('{kind}', {{ pointerId: {finger}, button: 0, bubbles: true }}))");

    private void Choose(string list, string value) => Browser.Do(
        $"const list = document.getElementById('{list}'); list.value = '{value}'; list.dispatchEvent(new Event('change'))");
}
