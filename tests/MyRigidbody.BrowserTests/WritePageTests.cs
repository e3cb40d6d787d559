using System.Text.Json;
using NUnit.Framework;
using OpenQA.Selenium;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The Write part of the lab, as a student uses it: from the starter to five lamps, by typing.</summary>
public sealed partial class WritePageTests : LabPageFixture
{
    // the page has the verdict on the text that it shows
    private const string Judged = "window.lab?.write && document.querySelector('.write .outcome').textContent && !document.querySelector('.write.stale')";

    private static readonly string[] Steps = ["velocity", "angularVelocity", "position", "orientation", "damping"];

    private TemporaryFolder _folder = null!;

    [OneTimeSetUp]
    public void Start()
    {
        _folder = new TemporaryFolder();
        Visit("zh");
    }

    // the page is not loaded anew: the compiler in it takes seconds
    [SetUp]
    public void Begin()
    {
        Browser.Resize(1200, 900);
        Browser.Do("report.setLanguage('zh'); document.querySelectorAll('dialog').forEach(dialog => dialog.close())");
        Browser.Do("if (lab.write.editor.text !== lab.write.starter) lab.set({ script: { text: lab.write.starter } })");
        WaitForVerdict();
    }

    [OneTimeTearDown]
    public void Stop() => _folder?.Dispose();

    [Test]
    public void A_student_types_the_five_steps_and_five_lamps_turn_right()
    {
        string[] typed =
        [
            "v += force / mass * dt; // 速度",
            "Matrix4x4 R = Matrix4x4.Rotate(transform.rotation); // 旋转矩阵\nMatrix4x4 I = R * I_ref * R.transpose; // 当前的转动惯量\nw += dt * I.inverse.MultiplyVector(torque); // 角速度",
            "transform.position += dt * v; // 位置",
            "Quaternion q = transform.rotation; // 朝向\nQuaternion d = new Quaternion(w.x * dt / 2, w.y * dt / 2, w.z * dt / 2, 0) * q; // 增量\n"
                + "transform.rotation = new Quaternion(q.x + d.x, q.y + d.y, q.z + d.z, q.w + d.w).normalized; // 归一化",
            "v *= 0.98f; // 衰减\nw *= 0.98f;",
        ];
        Assert.That(Lamps(), Is.All.EqualTo("missing"));

        for (int step = 0; step < typed.Length; step++)
        {
            Lamp(step).Click();
            Browser.Press(Keys.End + Keys.Enter);
            Type(typed[step]);

            Assert.That(Lamps(), Is.EqualTo(Steps.Select((_, i) => i <= step ? "right" : "missing")));
        }

        Browser.Photograph("write-right");
        Assert.That(Browser.Find(".write .outcome").Text, Is.EqualTo("五个步骤全部正确。"));
        Assert.That(Browser.Find(".write .comments").Text, Does.Contain("10").And.Contain("9"));
        Assert.That(Shadow(".sign.bare").Length, Is.EqualTo(1));
    }

    [Test]
    public void The_judged_motions_of_cube_and_box_are_replayed_beside_the_two_others()
    {
        Assert.That(Browser.Becomes("report.live?.()?.motion.bodies.length === 2"), Is.True);
        Browser.Do("document.querySelector('.write .replay').click()");

        Assert.That(Browser.Becomes("report.data.bodies.length === 6 && !report.live()"), Is.True);
    }

    [TestCase("210840007_学生一")]
    [TestCase("210840014_学生二")]
    [TestCase("210840329_学生四七")]
    [TestCase("210840812_学生一一六")]
    public void The_page_says_what_check_says(string student)
    {
        string script = Root.File($"tests/data/submissions/class/{student}/MyRigidbody.cs");
        using JsonDocument check = JsonDocument.Parse(LabProcess.Run(_folder.Path, "check", script, "--json").Output);
        JsonElement verdict = check.RootElement;

        Show(File.ReadAllText(script));

        Assert.That(Lamps(), Is.EqualTo(Steps.Select(step => verdict.GetProperty("steps").GetProperty(step).GetString())));
        Assert.That(Texts(".write .notes .help"), Is.EqualTo(verdict.GetProperty("findings").EnumerateArray().Select(finding => finding.GetProperty("zh").GetString())));
    }

    [Test]
    public void An_error_is_underlined_as_one_types_and_F8_goes_to_it()
    {
        Lamp(0).Click();
        Browser.Press(Keys.End + Keys.Enter);
        Type("w = 0.5f;");

        Assert.That(Shadow(".cm-lintRange-error"), Is.Not.Empty);
        Browser.Press(Keys.Home + Keys.ArrowUp + Keys.ArrowUp + Keys.F8);

        Assert.That(Shadow(".here").Single(), Does.StartWith("第 49 行：").And.Contain("CS0029").And.Contain("类型"));
        Assert.That(Browser.Becomes("document.querySelector('.write .editor').shadowRoot.querySelector('.cm-diagnostic-error')"), Is.True, "shown at its place, too");
    }

    [Test]
    public void An_endless_loop_is_said_in_one_line_and_the_page_goes_on()
    {
        Replace("// TODO 更新速度", "while (true) { }");

        Assert.That(Browser.Find(".write .outcome").Text, Is.EqualTo("Update 不会结束：存在死循环。"));
        Assert.That(Lamps(), Is.All.EqualTo("unknown"));

        Replace("while (true) { }", "v += force / mass * dt;");

        Assert.That(Lamps(), Is.EqualTo(new[] { "right", "missing", "missing", "missing", "missing" }));
    }

    // in one frame, so that only the runtime can see how much it holds
    [Test]
    public void A_script_that_takes_memory_without_end_is_named_and_the_page_goes_on()
    {
        Replace("// TODO 更新速度", "var all = new System.Collections.Generic.List<float[]>(); while (true) all.Add(new float[25000000]);");

        Assert.That(Browser.Find(".write .outcome").Text, Does.Contain("占用的内存过多"));
        Assert.That(Lamps(), Is.All.EqualTo("unknown"));

        Show(Starter.Replace("// TODO 更新速度", "v += force / mass * dt;", StringComparison.Ordinal));

        Assert.That(Lamps(), Is.EqualTo(new[] { "right", "missing", "missing", "missing", "missing" }));
    }

    [Test]
    public void A_script_that_throws_says_so_in_one_line()
    {
        Replace("// TODO 更新速度", "GetComponent<Rigidbody>().velocity = v;");

        Assert.That(Browser.Find(".write .outcome").Text, Does.Contain("Rigidbody"));
    }

    [Test]
    public void A_lamp_of_the_text_before_is_marked_until_the_new_verdict()
    {
        Browser.Do("lab.write.editor.replace('// nothing')");

        Assert.That(Browser.Get<string>("document.querySelector('.write .step').textContent"), Does.Contain("改动前"));
        WaitForVerdict();
        Assert.That(Browser.Get<string>("document.querySelector('.write .step').textContent"), Does.Not.Contain("改动前"));
    }

    [Test]
    public void Text_outlives_a_reload_and_what_was_replaced_can_be_taken_back()
    {
        Replace("// TODO 更新速度", "// 我的脚本");
        string mine = Text();
        Visit("zh");
        Assert.That(Text(), Is.EqualTo(mine));

        Browser.Find(".write .restart").Click();
        Assert.That(Text(), Is.EqualTo(mine), "asks first");
        Browser.Find(".write .restarting button[value=yes]").Click();
        Assert.That(Browser.Becomes("lab.write.editor.text === lab.write.starter"), Is.True);
        Assert.That(Text(), Is.EqualTo(Starter));

        Browser.Find(".write .back").Click();
        Assert.That(Text(), Is.EqualTo(mine));
    }

    [Test]
    public void Editor_begins_with_the_starter_of_the_package() => Assert.That(Text(), Is.EqualTo(Starter));

    [Test]
    public void The_tab_key_indents_and_can_be_left()
    {
        Lamp(0).Click();
        string before = Text();
        Browser.Press(Keys.Tab);
        Assert.That(Text(), Has.Length.EqualTo(before.Length + 4));

        Browser.Press(Keys.Escape + Keys.Tab);

        Assert.That(Browser.Get<bool>("document.activeElement === document.querySelector('.write .editor')"), Is.False);
    }

    [TestCase("zh")]
    [TestCase("en")]
    public void Names_of_steps_are_those_of_check_before_it_is_there(string language)
    {
        Browser.Do($"report.setLanguage('{language}')");
        string[] judged = Texts(".write .step .of");

        Assert.That(Enumerable.Range(0, 5).Select(step => Browser.Get<string>($"report.word('write.step.{step}')")), Is.EqualTo(judged));
    }

    [Test]
    public void The_lamps_stand_above_the_editor_on_a_phone_and_nothing_is_cut_off()
    {
        Browser.Resize(390, 844, isPhone: true);
        Browser.Do("document.getElementById('write-part').scrollIntoView()");
        Browser.Photograph("write-phone");

        Assert.That(Browser.Get<int>("document.documentElement.scrollWidth"), Is.LessThanOrEqualTo(390));
        Assert.That(Browser.Get<double>("document.querySelector('.write .lamps').getBoundingClientRect().bottom - document.querySelector('.write .editor').getBoundingClientRect().top"), Is.LessThan(0));
        Assert.That(Browser.Get<bool>("[...document.querySelectorAll('.write .step')].every(step => step.scrollWidth <= step.clientWidth)"), Is.True);
    }

    private static string Starter => File.ReadAllText(Root.File("UnityProject/Assets/MyRigidbodyStarter/MyRigidbody.cs"));

    private void Visit(string language)
    {
        Browser.Visit($"{Site.Address}#tab=write&lang={language}", "window.lab?.write");
        WaitForVerdict();
    }

    private string Text() => Browser.Get<string>("lab.write.editor.text");

    private IWebElement Lamp(int step) => Browser.Find($".write .lamps li:nth-child({step + 1}) button");

    private string[] Lamps() => [.. Array(
        "[...document.querySelectorAll('.write .step')].map(step => step.className.replace('step ', ''))")];

    private string[] Texts(string selector) => Array($"[...document.querySelectorAll('{selector}')].map(element => element.textContent)");

    // the editor is in a shadow root
    private string[] Shadow(string selector) => Array($"[...document.querySelector('.write .editor').shadowRoot.querySelectorAll('{selector}')].map(element => element.textContent)");

    private string[] Array(string expression) => JsonSerializer.Deserialize<string[]>(Browser.Get<string>($"JSON.stringify({expression})"))!;

    private void Type(string text)
    {
        Browser.Press(text);
        WaitForVerdict();
    }

    private void Replace(string old, string by) => Show(Text().Replace(old, by, StringComparison.Ordinal));

    private void Show(string text)
    {
        Browser.Do($"lab.write.editor.replace({JsonSerializer.Serialize(text)})");
        WaitForVerdict();
    }

    // seconds at most, but on a machine that does much else
    private void WaitForVerdict() => Assert.That(Browser.Becomes(Judged, 90), Is.True, "no verdict");
}
