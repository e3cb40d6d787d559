using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>A link to the lab carries its state; damaged parts are reported, and the rest is used.</summary>
public sealed class LinkTests : LabPageFixture
{
    private const string Ready = "window.report?.pictures?.() > 0 && document.getElementById('copy-link') && lab.write?.editor";
    private const string Said = "document.getElementById('said')";

    private const string Mine = """{ "schema": "rigid-body-scene/1", "name": "我的陀螺", "step": 0.01, "duration": 5, "bodies": [{ "name": "top", "inertia": { "principal": [1, 2, 3] }, "angularVelocity": [1, 2, 3] }] }""";

    [SetUp]
    public void Begin() => Forget();

    [Test]
    public void Scene_integrator_script_and_language_arrive()
    {
        const string Script = "// 学生的脚本 🙂\nclass MyRigidbody { }\n";
        Browser.Visit(Site.Address + "#lang=zh", Ready);
        Browser.Do("lab.set({ scene: 'tumbling-slab', sceneText: undefined })");
        Assert.That(Browser.Becomes("lab.state.sceneText?.includes('tumbling')"), Is.True);
        Browser.Do("lab.set({ rule: 'Splitting' })");
        Assert.That(Browser.Becomes("document.getElementById('rule').value === 'Splitting'"), Is.True);
        Browser.Do($"lab.write.editor.replace({Quoted(Script)})");
        Assert.That(Browser.Becomes($"lab.state.script?.text === {Quoted(Script)}"), Is.True);
        string link = Copied();
        Assert.That(link, Does.Contain("scene=tumbling-slab").And.Contain("rule=Splitting").And.Contain("lang=zh").And.Contain("script=").And.Not.Contain("own="));

        Forget();
        Browser.Visit(link, Ready);

        Assert.That(Browser.Get<string>("document.getElementById('scene').value"), Is.EqualTo("tumbling-slab"));
        Assert.That(Browser.Get<string>("document.getElementById('rule').value"), Is.EqualTo("Splitting"));
        Assert.That(Browser.Get<string>("document.documentElement.lang"), Is.EqualTo("zh"));
        Assert.That(Browser.Get<string>("lab.write.editor.text"), Is.EqualTo(Script));
        Assert.That(Browser.Get<bool>(Said + ".hidden"), Is.True);
    }

    [Test]
    public void A_scene_of_ones_own_arrives()
    {
        Browser.Visit(Site.Address, Ready);
        Browser.Do($"lab.set({{ scene: 'my-top', sceneText: {Quoted(Mine)} }})");
        Assert.That(Browser.Becomes("document.getElementById('scene').value === 'my-top'"), Is.True);
        string link = Copied();

        Browser.Visit(link, Ready);

        Assert.That(Browser.Get<string>("lab.state.sceneText"), Is.EqualTo(Mine));
        Assert.That(Browser.Get<string>("report.data.bodies[0].name"), Is.EqualTo("top"));
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
        Browser.Visit(Site.Address + hash, Ready + $" && !{Said}.hidden");

        Assert.That(Browser.Find("#said").Text, Does.EndWith($"{part}.").And.Contain("damaged"));
        Assert.That(Browser.Get<string>("document.getElementById('scene').value"), Is.EqualTo("lab"));
    }

    [Test]
    public void A_scene_that_is_none_is_refused_with_its_reason_and_the_lab_plays()
    {
        Browser.Visit(Site.Address, Ready);
        Browser.Do($"lab.set({{ scene: 'mine', sceneText: {Quoted(Mine)} }})");
        Assert.That(Browser.Becomes("document.getElementById('scene').value === 'mine'"), Is.True);
        // a part of the link is missing
        Browser.Do("lab.state.sceneText = '{ \"schema\": \"rigid-body-scene/1\" }'");
        string link = Copied();

        Browser.Visit(link, Ready + " && document.getElementById('scene').value === 'lab'");

        Assert.That(Browser.Becomes($"{Said}.textContent.includes('mine.json') && {Said}.textContent.includes('name')"), Is.True);
    }

    [Test]
    public void A_script_that_is_too_long_is_left_out_and_that_is_said()
    {
        Browser.Visit(Site.Address, Ready);
        // letters that cannot be compressed
        Browser.Do("lab.state.script = { name: 'MyRigidbody.cs', text: Array.from({ length: 20000 }, (_, i) => String.fromCharCode(33 + Math.imul(i * i + 1, 2654435761) / 7e5 % 90)).join('') }");
        string link = Copied();

        Assert.That(link, Does.Not.Contain("script=").And.Contain("scene=lab"));
        Assert.That(link.Length, Is.LessThan(8000));
        Assert.That(Browser.Find("#said").Text, Does.Contain("too long").And.Contain("save it as a file"));
    }

    [Test]
    public void After_a_change_the_address_says_nothing_old()
    {
        Browser.Visit(Site.Address + "#scene=heavy-top&lang=en", Ready);
        Assert.That(Browser.Get<string>("lab.state.scene"), Is.EqualTo("heavy-top"));
        Assert.That(Browser.Get<string>("location.hash"), Does.Contain("heavy-top"));

        Browser.Do("lab.set({ scene: 'hammer', sceneText: undefined })");

        Assert.That(Browser.Becomes("!location.hash.includes('heavy-top')"), Is.True);
        Assert.That(Browser.Get<string>("location.hash"), Is.EqualTo("#lang=en"));
    }

    /// <summary>The link, as the button puts it into the clipboard or, where that may not be written, into the address.</summary>
    private string Copied()
    {
        Browser.Do("window.copied = undefined; navigator.clipboard.writeText = text => { window.copied = text; return Promise.resolve(); }; document.getElementById('copy-link').click()");
        Assert.That(Browser.Becomes("window.copied"), Is.True);
        Assert.That(Browser.Becomes($"{Said}.textContent"), Is.True);
        return Browser.Get<string>("window.copied");
    }

    private static string Quoted(string text) => System.Text.Json.JsonSerializer.Serialize(text);
}
