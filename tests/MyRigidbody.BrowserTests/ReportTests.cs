using System.Globalization;
using NUnit.Framework;
using OpenQA.Selenium;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The page of the lab's scene, as a reader uses it.</summary>
public sealed class ReportTests : BrowserFixture
{
    private TemporaryFolder _folder = null!;
    private string _page = null!;

    [OneTimeSetUp]
    public void Start()
    {
        _folder = new TemporaryFolder();
        _page = Pages.Lab(_folder);
    }

    [SetUp]
    public void Open()
    {
        Browser.Resize(1200, 900);
        Browser.Prefer("light");
        Browser.Open(_page, $"#fresh={Guid.NewGuid()}");
        Browser.Reload();
    }

    [TearDown]
    public void Nothing_is_fetched()
    {
        Assert.That(Browser.Requests(), Is.Not.Empty.And.All.StartsWith("file:").And.All.Contains("/report.html"));
        Assert.That(Browser.Get<int>("performance.getEntriesByType('resource').length"), Is.Zero);
    }

    [OneTimeTearDown]
    public void Stop() => _folder?.Dispose();

    [Test]
    public void Plays_by_itself_until_it_is_paused()
    {
        Assert.That(Browser.Becomes("report.time() > 0.3"), Is.True);

        Browser.Find("#play").Click();

        double paused = Browser.Get<double>("report.time()");
        Thread.Sleep(300);
        Assert.That(Browser.Get<double>("report.time()"), Is.EqualTo(paused));
        Assert.That(Browser.Find("#play").Text, Does.Contain("Play"));
        Assert.That(Browser.Find("#clock").Text, Is.EqualTo(paused.ToString("F2", CultureInfo.InvariantCulture) + " s"));
    }

    [Test]
    public void Scrubbing_moves_time_picture_line_and_keys()
    {
        Scrub(0.5);
        string early = Picture();
        double line = Browser.Get<double>("document.getElementById('now').getBoundingClientRect().left");
        string[] heldEarly = Held();

        Scrub(1.75);

        Assert.That(Browser.Get<double>("report.time()"), Is.EqualTo(1.75));
        Assert.That(Picture(), Is.Not.EqualTo(early));
        double way = (1.75 - 0.5) / 10 * Browser.Get<double>("document.querySelector('#curves .plot').getBoundingClientRect().width");
        Assert.That(Browser.Get<double>("document.getElementById('now').getBoundingClientRect().left") - line, Is.EqualTo(way).Within(2));
        Assert.That(heldEarly, Is.EqualTo(new[] { "r" }));
        Assert.That(Held(), Is.EqualTo(new[] { "r", "→", "↑" }));
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(137)]
    [TestCase(500)]
    public void Pose_that_is_drawn_is_that_of_the_file(int step)
    {
        foreach ((string body, int index) in new[] { ("MyRigidbody", 0), ("DefaultRigidbody", 1) })
        {
            Dictionary<string, double> row = Pages.Row(_folder, body, step);
            string pose = $"report.poseAt({row["t"].ToString("R", CultureInfo.InvariantCulture)})[{index}]";
            Assert.That(Browser.Get<string>(pose + ".name"), Is.EqualTo(body));
            foreach ((string part, string columns, double within) in new[]
            {
                ("position", "px,py,pz", 1e-4), ("orientation", "qw,qx,qy,qz", 2e-5), ("spin", "wx,wy,wz", 1e-4), ("momentum", "Lx,Ly,Lz", 1e-4),
            })
            {
                string[] names = columns.Split(',');
                for (int i = 0; i < names.Length; i++)
                    Assert.That(Browser.Get<double>($"{pose}.{part}[{i}]"), Is.EqualTo(row[names[i]]).Within(within), $"{body} {names[i]}");
            }
        }
    }

    [Test]
    public void Between_two_steps_the_pose_is_between_them()
    {
        double before = Pages.Row(_folder, "DefaultRigidbody", 137)["px"], after = Pages.Row(_folder, "DefaultRigidbody", 138)["px"];

        double middle = Browser.Get<double>("report.poseAt(137.5 * 0.02)[1].position[0]");

        Assert.That(middle, Is.EqualTo((before + after) / 2).Within(1e-4));
        Assert.That(Browser.Get<double>("Math.hypot(...report.poseAt(137.5 * 0.02)[1].orientation)"), Is.EqualTo(1).Within(1e-12));
    }

    [Test]
    public void A_click_in_a_plot_sets_the_time()
    {
        Scrub(0);
        // 62 pixels of scale on the left, 12 on the right: as the plots are laid out
        double width = Browser.Get<double>("document.getElementById('curves').clientWidth") - 62 - 12;

        Browser.Click("#curves", (int)(62 + 0.6 * width), 80);

        Assert.That(Browser.Becomes("report.time() > 0"), Is.True);
        Assert.That(Browser.Get<double>("report.time()"), Is.EqualTo(6).Within(0.1));
    }

    [Test]
    public void Keys_play_step_and_jump()
    {
        Scrub(1);
        Browser.Press(Keys.ArrowRight);
        double next = Browser.Get<double>("report.time()");
        Browser.Press(Keys.ArrowLeft + Keys.ArrowLeft);
        double back = Browser.Get<double>("report.time()");
        Browser.Press(Keys.End);
        double end = Browser.Get<double>("report.time()");
        Browser.Press(Keys.Home);
        double home = Browser.Get<double>("report.time()");
        Browser.Press(" ");

        Assert.That(new[] { next, back, end, home }, Is.EqualTo(new[] { 1.02, 0.98, 10, 0 }).Within(1e-9));
        Assert.That(Browser.Becomes("report.playing() && report.time() > 0"), Is.True);
    }

    [Test]
    public void Dragging_wheel_and_buttons_change_the_view_and_reset_brings_it_back()
    {
        Scrub(1.2);
        string before = Picture();
        Browser.Drag("#stage", 120, 40);
        string turned = Picture();
        Browser.Find("#trails").Click();
        string bare = Picture();
        Browser.Find("#trails").Click();
        Browser.Find("#reset").Click();

        Assert.That(turned, Is.Not.EqualTo(before));
        Assert.That(bare, Is.Not.EqualTo(turned));
        Assert.That(Picture(), Is.EqualTo(before));
    }

    [Test]
    public void Language_is_switched_everywhere_and_remembered()
    {
        Assert.That(Visible("h2"), Does.Contain("Replay").And.Not.Contain("回放"));

        Browser.Find("#language").Click();
        Assert.That(Visible("h2"), Does.Contain("回放").And.Not.Contain("Replay"));
        Assert.That(Visible("#curves"), Does.Contain("时间"));
        Assert.That(Browser.Find("#play").Text, Does.Contain("播放").Or.Contain("暂停"));

        Browser.Reload();
        Assert.That(Browser.Get<string>("document.documentElement.lang"), Is.EqualTo("zh"));
        Assert.That(Visible("h2"), Does.Contain("回放"));
    }

    [Test]
    public void Theme_follows_the_system_until_it_is_chosen()
    {
        string light = Back();
        Browser.Prefer("dark");
        Assert.That(Browser.Becomes("document.documentElement.dataset.theme === 'dark'"), Is.True);
        string dark = Back();
        Browser.Find("#theme").Click();

        Assert.That(dark, Is.Not.EqualTo(light));
        Assert.That(Back(), Is.EqualTo(light));
        Browser.Reload();
        Assert.That(Back(), Is.EqualTo(light));
    }

    [Test]
    public void Nothing_sticks_out_of_a_phone()
    {
        Browser.Resize(360, 740, isPhone: true);
        Browser.Reload();

        Assert.That(Browser.Get<int>("document.documentElement.scrollWidth"), Is.EqualTo(360));
        Assert.That(Browser.Get<int>("document.getElementById('curves').querySelector('svg').getBoundingClientRect().width"), Is.LessThanOrEqualTo(360));
    }

    [Test]
    public void Photographs_for_the_eye()
    {
        foreach ((string name, string hash, int width, bool isPhone) in new[]
        {
            ("light", "#lang=en&theme=light", 1200, false),
            ("dark", "#lang=en&theme=dark", 1200, false),
            ("chinese", "#lang=zh&theme=light", 1200, false),
            ("phone", "#lang=en&theme=light", 360, true),
        })
        {
            Browser.Resize(width, isPhone ? 740 : 865, isPhone);
            Browser.Open(_page, hash);
            Browser.Reload();
            Scrub(2.2);
            Thread.Sleep(300);
            Browser.Photograph(name);
            Assert.That(Browser.Get<string>("document.documentElement.lang"), Is.EqualTo(hash[6..8]));
        }
    }

    private void Scrub(double time)
    {
        Browser.Do("if (report.playing()) document.getElementById('play').click()");
        Browser.Do($"const time = document.getElementById('time'); time.value = {time.ToString("R", CultureInfo.InvariantCulture)}; time.dispatchEvent(new Event('input'))");
    }

    /// <summary>What is on the canvas, once all that changed is drawn.</summary>
    private string Picture()
    {
        Browser.Do("window.drawn = false; requestAnimationFrame(() => requestAnimationFrame(() => window.drawn = true))");
        Browser.Becomes("window.drawn");
        return Browser.Get<string>("document.getElementById('stage').toDataURL()");
    }

    private string[] Held() => Browser.Get<string>("[...document.querySelectorAll('.on')].map(key => key.textContent).join(' ')").Split(' ');

    private string Back() => Browser.Get<string>("getComputedStyle(document.body).backgroundColor");

    private string Visible(string selector) => Browser.Get<string>($"[...document.querySelectorAll('{selector}')].map(element => element.innerText ?? element.textContent).join(' ') || ' '");
}
