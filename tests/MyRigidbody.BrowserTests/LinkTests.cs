using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>A link to the lab carries its state; what is damaged in one is said, and the rest is taken.</summary>
public sealed class LinkTests
{
    private const string Ready = "window.report?.pictures?.() > 0 && document.getElementById('copy-link') && lab.write?.editor";
    private const string Said = "document.getElementById('said')";

    private const string Mine = """{ "schema": "rigid-body-scene/1", "name": "我的陀螺", "step": 0.01, "duration": 5, "bodies": [{ "name": "top", "inertia": { "principal": [1, 2, 3] }, "angularVelocity": [1, 2, 3] }] }""";

    private Browser _browser = null!;
    private LabSite _site = null!;

    [OneTimeSetUp]
    public void Start()
    {
        _site = new LabSite();
        _browser = new Browser();
    }

    [SetUp]
    public void Forget()
    {
        _browser.Visit(_site.Address + "page.css", "true");
        _browser.Do("localStorage.clear(); sessionStorage.clear()");
    }

    [TearDown]
    public void Nothing_complains() => Assert.That(_browser.Complaints(), Is.Empty);

    [OneTimeTearDown]
    public void Stop()
    {
        _browser?.Dispose();
        _site?.Dispose();
    }

    [Test]
    public void Scene_rule_script_and_language_arrive()
    {
        const string Script = "// 学生的脚本 🙂\nclass MyRigidbody { }\n";
        _browser.Visit(_site.Address + "#lang=zh", Ready);
        _browser.Do("lab.set({ scene: 'tumbling-slab', sceneText: undefined })");
        Assert.That(_browser.Becomes("lab.state.sceneText?.includes('tumbling')"), Is.True);
        _browser.Do("lab.set({ rule: 'Splitting' })");
        Assert.That(_browser.Becomes("document.getElementById('rule').value === 'Splitting'"), Is.True);
        _browser.Do($"lab.write.editor.replace({Quoted(Script)})");
        Assert.That(_browser.Becomes($"lab.state.script?.text === {Quoted(Script)}"), Is.True);
        string link = Copied();
        Assert.That(link, Does.Contain("scene=tumbling-slab").And.Contain("rule=Splitting").And.Contain("lang=zh").And.Contain("script=").And.Not.Contain("own="));

        Forget();
        _browser.Visit(link, Ready);

        Assert.That(_browser.Get<string>("document.getElementById('scene').value"), Is.EqualTo("tumbling-slab"));
        Assert.That(_browser.Get<string>("document.getElementById('rule').value"), Is.EqualTo("Splitting"));
        Assert.That(_browser.Get<string>("document.documentElement.lang"), Is.EqualTo("zh"));
        Assert.That(_browser.Get<string>("lab.write.editor.text"), Is.EqualTo(Script));
        Assert.That(_browser.Get<bool>(Said + ".hidden"), Is.True);
    }

    [Test]
    public void A_scene_of_ones_own_arrives()
    {
        _browser.Visit(_site.Address, Ready);
        _browser.Do($"lab.set({{ scene: 'my-top', sceneText: {Quoted(Mine)} }})");
        Assert.That(_browser.Becomes("document.getElementById('scene').value === 'my-top'"), Is.True);
        string link = Copied();

        _browser.Visit(link, Ready);

        Assert.That(_browser.Get<string>("lab.state.sceneText"), Is.EqualTo(Mine));
        Assert.That(_browser.Get<string>("report.data.bodies[0].name"), Is.EqualTo("top"));
    }

    [TestCase("#scene=no-such-scene", "scene")]
    [TestCase("#rule=Magic", "rule")]
    [TestCase("#scene=%3Cscript%3E", "scene")]
    [TestCase("#tab=../x", "tab")]
    [TestCase("#script=AAAA", "script")]
    [TestCase("#script=%E4%BD%A0", "script")]
    [TestCase("#script=", "script")]
    [TestCase("#own=q1bKz8ss", "own")]
    public void What_is_damaged_is_named_in_one_line_and_the_lab_plays(string hash, string part)
    {
        _browser.Visit(_site.Address + hash, Ready + $" && !{Said}.hidden");

        Assert.That(_browser.Find("#said").Text, Does.EndWith($"{part}.").And.Contain("damaged"));
        Assert.That(_browser.Get<string>("document.getElementById('scene').value"), Is.EqualTo("lab"));
    }

    [Test]
    public void A_scene_that_is_none_is_refused_with_its_reason_and_the_lab_plays()
    {
        _browser.Visit(_site.Address, Ready);
        _browser.Do($"lab.set({{ scene: 'mine', sceneText: {Quoted(Mine)} }})");
        Assert.That(_browser.Becomes("document.getElementById('scene').value === 'mine'"), Is.True);
        // somebody has lost a part of it
        _browser.Do("lab.state.sceneText = '{ \"schema\": \"rigid-body-scene/1\" }'");
        string link = Copied();

        _browser.Visit(link, Ready + " && document.getElementById('scene').value === 'lab'");

        Assert.That(_browser.Becomes($"{Said}.textContent.includes('mine.json') && {Said}.textContent.includes('name')"), Is.True);
    }

    [Test]
    public void A_script_that_is_too_long_is_left_out_and_that_is_said()
    {
        _browser.Visit(_site.Address, Ready);
        // letters that nobody can make shorter
        _browser.Do("lab.state.script = { name: 'MyRigidbody.cs', text: Array.from({ length: 20000 }, (_, i) => String.fromCharCode(33 + Math.imul(i * i + 1, 2654435761) / 7e5 % 90)).join('') }");
        string link = Copied();

        Assert.That(link, Does.Not.Contain("script=").And.Contain("scene=lab"));
        Assert.That(link.Length, Is.LessThan(8000));
        Assert.That(_browser.Find("#said").Text, Does.Contain("too long").And.Contain("save it as a file"));
    }

    [Test]
    public void After_a_change_the_address_says_nothing_old()
    {
        _browser.Visit(_site.Address + "#scene=heavy-top&lang=en", Ready);
        Assert.That(_browser.Get<string>("lab.state.scene"), Is.EqualTo("heavy-top"));
        Assert.That(_browser.Get<string>("location.hash"), Does.Contain("heavy-top"));

        _browser.Do("lab.set({ scene: 'hammer', sceneText: undefined })");

        Assert.That(_browser.Becomes("!location.hash.includes('heavy-top')"), Is.True);
        Assert.That(_browser.Get<string>("location.hash"), Is.EqualTo("#lang=en"));
    }

    /// <summary>The link, as the button puts it into the clipboard or, where that may not be written, into the address.</summary>
    private string Copied()
    {
        _browser.Do("window.copied = undefined; navigator.clipboard.writeText = text => { window.copied = text; return Promise.resolve(); }; document.getElementById('copy-link').click()");
        Assert.That(_browser.Becomes("window.copied"), Is.True);
        Assert.That(_browser.Becomes($"{Said}.textContent"), Is.True);
        return _browser.Get<string>("window.copied");
    }

    private static string Quoted(string text) => System.Text.Json.JsonSerializer.Serialize(text);
}
