using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>
/// Code in a worker of the lab reaches no server, and a script's worker stores nothing, even if the list of allowed names had a
/// hole: the attacks run after the worker's own module, and a server at another address records requests.
/// </summary>
public sealed class WorkerPrisonTests : LabPageFixture
{
    private static readonly string[] ToServer = ["fetch", "post", "xhr", "socket", "events", "import", "worker", "font"];

    private static readonly string[] ToStorage = ["indexedDB", "caches", "folder", "files", "filesAtOnce", "channel", "locks"];

    private TemporaryFolder _folder = null!;
    private LabSite _other = null!;
    private int _noted;

    private static string Attacks => File.ReadAllText(Root.File("tests/MyRigidbody.BrowserTests/attacks.js"));

    [OneTimeSetUp]
    public void Start()
    {
        _folder = new TemporaryFolder();
        File.WriteAllText(_folder.File("index.html"), "<!DOCTYPE html><link rel=\"icon\" href=\"data:,\"><title>free</title>");
        File.WriteAllText(_folder.File("free.js"), Attacks);
        _other = new LabSite(_folder.Path);
        // behind what a worker of the page is made of; no worker is ended before it has answered
        Browser.BeforeEachPage($$"""
            window.workers = [];
            window.Blob = class extends Blob {
              constructor(parts, about) { super(about?.type === 'text/javascript' ? [...parts, ';\n', {{JsonSerializer.Serialize(Attacks)}}] : parts, about); }
            };
            window.Worker = class extends Worker {
              constructor(...all) { super(...all); workers.push(this); }
              attack(there) {
                const { port1, port2 } = new MessageChannel();
                port1.onmessage = ({ data }) => { this.attacked = data; };
                this.postMessage({ attack: there }, [port2]);
              }
              terminate() { }
            };
            """);
    }

    [OneTimeTearDown]
    public void Stop()
    {
        _other?.Dispose();
        _folder?.Dispose();
    }

    [Test]
    public void Where_nothing_is_forbidden_every_attack_that_a_worker_has_arrives()
    {
        Browser.Visit(_other.Address, "true");
        Dictionary<string, string> came = Attack("new Worker('free.js', { type: 'module' })");

        Assert.That(Noted(), Is.SupersetOf(ToServer));
        Assert.That(came.Where(attack => attack.Value == "done").Select(attack => attack.Key), Is.SupersetOf(ToStorage.Append("eval").Append("function")));
        // checks that nothing was received at the addresses
        Browser.Complaints();
    }

    [Test]
    public void The_worker_of_scripts_reaches_no_server_and_keeps_nothing()
    {
        Browser.Visit(Site.Address + "#lang=en", "window.lab?.write && document.querySelector('.write .outcome').textContent && !document.querySelector('.write.stale')", 90);

        Dictionary<string, string> came = Attack("workers[0]");

        Assert.That(came.Where(attack => attack.Value == "done").Select(attack => attack.Key), Is.Empty);
        Assert.That(Noted(), Is.Empty);
        // refused by the policy, which says so in the console; nothing else is there to be refused
        Assert.That(Browser.Complaints(), Is.Not.Empty.And.All.Contains("Content Security Policy"));
    }

    [Test]
    public void The_worker_that_measures_reaches_no_server()
    {
        Browser.Visit(Site.Address + "#lang=en", "window.report?.pictures?.() > 1 && document.getElementById('measure')?.textContent");
        Browser.Do("workers.length = 0; document.getElementById('measure').click()");

        Dictionary<string, string> came = Attack("workers[0]");

        Assert.That(ToServer.Select(attack => came[attack]), Is.All.Not.EqualTo("done"));
        Assert.That(came["eval"], Is.Not.EqualTo("done"));
        Assert.That(Noted(), Is.Empty);
        // the runtime, if it was there already, says something of its own
        Assert.That(Browser.Complaints(), Has.Some.Contains("Content Security Policy"));
    }

    /// <summary>The result of each attack from a worker.</summary>
    private Dictionary<string, string> Attack(string worker)
    {
        _noted = _other.Sent.Length;
        Browser.Do($"(window.attacker = {worker}).attack('{_other.Address}')");
        Assert.That(Browser.Becomes("attacker.attacked", 60), Is.True);
        Dictionary<string, string> came = JsonSerializer.Deserialize<Dictionary<string, string>>(Browser.Get<string>("JSON.stringify(attacker.attacked)"))!;
        TestContext.Out.WriteLine(string.Join('\n', came));
        return came;
    }

    // since the attack
    private IEnumerable<string> Noted() => _other.Sent.Skip(_noted).Select(sent => sent.Path);
}
