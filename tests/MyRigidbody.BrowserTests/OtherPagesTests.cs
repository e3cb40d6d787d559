using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Pages of other scenes than the lab's: long, crowded, hostile, recorded.</summary>
public sealed class OtherPagesTests : BrowserFixture
{
    [SetUp]
    public void Rest() => Browser.Prefer("light", motion: "reduce");

    [Test]
    public void Who_wants_little_motion_starts_it_by_hand()
    {
        using TemporaryFolder folder = new();
        Browser.Open(Pages.Lab(folder));
        Thread.Sleep(300);

        Assert.That(Browser.Get<double>("report.time()"), Is.Zero);
        Assert.That(Browser.Get<bool>("report.playing()"), Is.False);
    }

    [Test]
    public void Four_bodies_and_3000_steps_play()
    {
        using TemporaryFolder folder = new();
        string page = Pages.Scene(folder, "four", 0.01, 3000, "one", "two", "three", "four");
        Browser.Open(page);
        double load = Browser.Get<double>("performance.getEntriesByType('navigation')[0].loadEventEnd");
        Browser.Do("document.getElementById('play').click(); window.from = [report.pictures(), performance.now()]");
        Thread.Sleep(3000);
        double rate = Browser.Get<double>("(report.pictures() - from[0]) / (performance.now() - from[1]) * 1000");

        // figures for a reader; no bound, because the machine may be busy
        TestContext.Out.WriteLine($"{new FileInfo(page).Length} bytes, loaded in {load:F0} ms, {rate:F0} pictures a second");
        Assert.That(Browser.Get<int>("report.data.times.length"), Is.EqualTo(3001));
        Assert.That(Browser.Get<double>("report.time()"), Is.GreaterThan(0));
        Assert.That(new FileInfo(page).Length, Is.LessThan(5_000_000));
    }

    [Test]
    public void A_million_steps_open_thinned_and_it_is_said()
    {
        using TemporaryFolder folder = new();
        Browser.Open(Pages.Scene(folder, "long", 0.001, 1_000_000, "one"));

        Assert.That(Browser.Get<int>("report.data.times.length"), Is.InRange(1500, 3001));
        Assert.That(Browser.Get<double>("report.motion.end"), Is.EqualTo(1000));
        Assert.That(Browser.Find(".thinned").Text, Does.Contain("1000000"));
    }

    [Test]
    public void Names_are_shown_and_do_nothing()
    {
        const string Hostile = "</script><img src=x onerror=\"window.broken=1\"><!-- {{ page.file }} &amp;";
        using TemporaryFolder folder = new();
        Browser.Open(Pages.Scene(folder, Hostile, 0.01, 100, Hostile, "<b>刚体</b>"));

        Assert.That(Browser.Find("h1").Text, Is.EqualTo(Hostile));
        Assert.That(Browser.Get<string>("report.data.bodies[0].name"), Is.EqualTo(Hostile));
        Assert.That(Browser.Get<int>("document.querySelectorAll('body img, body b').length"), Is.Zero);
        Assert.That(Browser.Get<bool>("window.broken === undefined"), Is.True);
        Assert.That(Browser.Get<string>("document.getElementById('curves').textContent"), Does.Contain("<b>刚体</b>"));
    }

    [Test]
    public void A_page_that_asked_for_something_would_be_refused_and_noticed()
    {
        using TemporaryFolder folder = new();
        Browser.Open(Pages.Lab(folder));
        Browser.Do("const image = new Image(); image.src = 'http://127.0.0.1:9/x.png'; fetch('http://127.0.0.1:9/').catch(() => window.refused = true)");

        Assert.That(Browser.Becomes("window.refused"), Is.True);
        Assert.That(Browser.Complaints(), Has.Some.Contains("img-src").And.Some.Contains("Content Security Policy"));
    }

    [Test]
    public void A_recording_stands_beside_ours()
    {
        using TemporaryFolder folder = new();
        Browser.Open(Pages.Recording(folder));

        Assert.That(Browser.Get<string>("report.data.bodies.map(body => body.name).join()"), Does.StartWith("UnityRigidbody,").And.EndWith("(recorded)"));
        Assert.That(Browser.Find("#recording .lead").Text, Does.Contain("bit for bit"));
        Assert.That(Browser.Get<double>("Math.max(...report.data.pairs[0].distance)"), Is.Zero);
    }
}
