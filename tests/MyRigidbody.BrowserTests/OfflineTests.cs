using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The lab in a browser without a network, and from one version to the next: in a folder of a server that has other sites too.</summary>
public sealed class OfflineTests
{
    private const string Kept = "navigator.serviceWorker.controller && window.report?.pictures?.() > 3";
    private const string Judged = "document.querySelector('.write .outcome').textContent && !document.querySelector('.write.stale')";

    private const string Compiler = "write/";

    // the programs of the page are many files, and a machine may be busy
    private const double Patience = 120;

    private TemporaryFolder _folder = null!;
    private LabSite _site = null!;
    private Browser _browser = null!;
    private string _page = string.Empty;

    /// <summary>Keeps the whole site, or one without the compiler, which is most of it and says nothing of versions.</summary>
    private void Load(bool withCompiler)
    {
        _folder = new TemporaryFolder();
        foreach (string name in SiteFiles.Names.Where(name => withCompiler || !name.StartsWith(Compiler, StringComparison.Ordinal)))
        {
            string copy = _folder.File("lab/" + name);
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(SiteFiles.InFolder(name), copy);
        }

        if (!withCompiler)
        {
            string worker = _folder.File("lab/service-worker.js"), all = File.ReadAllText(worker), fewer = Regex.Replace(all, $",\"{Compiler}[^\"]+\":\"[^\"]+\"", string.Empty);
            Assert.That(fewer, Does.Not.Contain(Compiler).And.Not.EqualTo(all));
            File.WriteAllText(worker, fewer);
        }

        _site = new LabSite(_folder.Path);
        _browser = new Browser();
        _page = _site.Address + "lab/";
        Visit(_page, Kept);
    }

    [TearDown]
    public void Stop()
    {
        _browser?.Dispose();
        _site?.Dispose();
        _folder?.Dispose();
    }

    [Test]
    public void Page_that_was_loaded_opens_without_a_server_and_judges()
    {
        Load(withCompiler: true);
        _site.Dispose();
        Visit(_page + "?from=a-link#lang=zh", Judged);

        Assert.That(_browser.Get<string>("document.documentElement.lang"), Is.EqualTo("zh"));
        Assert.That(_browser.Complaints(), Is.Empty);
    }

    [Test]
    public void New_version_takes_the_place_of_the_old_one()
    {
        Load(withCompiler: false);
        Publish("second");
        // finds it, then has it
        Visit(_page, Kept);
        Assert.That(Becomes("navigator.serviceWorker.getRegistration().then(found => window.found = found) && window.found?.waiting"), Is.True);
        Assert.That(Version(), Is.EqualTo("undefined"));
        Visit(_page, "document.documentElement.dataset.site === 'second'");

        Assert.That(Becomes("caches.keys().then(names => window.names = names.length) && window.names === 1"), Is.True);
    }

    [Test]
    public void Two_open_pages_stay_with_one_version()
    {
        Load(withCompiler: false);
        _browser.Do($"window.other = window.open('{_page}')");
        Assert.That(Becomes("other.report?.pictures?.() > 3"), Is.True);
        Publish("second");
        _browser.Do("navigator.serviceWorker.getRegistration().then(found => (window.found = found).update())");
        Assert.That(Becomes("window.found?.waiting"), Is.True);

        _browser.Do("other.location.reload()");
        Thread.Sleep(1500);
        Assert.That(Becomes("other.report?.pictures?.() > 3"), Is.True);
        Assert.That(_browser.Get<string>("String(other.document.documentElement.dataset.site)"), Is.EqualTo(Version()).And.EqualTo("undefined"));

        _browser.Do("other.close()");
        Visit(_page, "document.documentElement.dataset.site === 'second'");
    }

    [Test]
    public void File_of_another_version_is_not_taken()
    {
        Load(withCompiler: false);
        // a server in the middle of being changed: the list is new, the page is old
        Publish("second", withPage: false);
        _browser.Do("navigator.serviceWorker.getRegistration().then(found => found.update()).catch(() => {}).finally(() => window.updated = true)");
        Assert.That(Becomes("window.updated"), Is.True);
        Assert.That(Becomes("navigator.serviceWorker.getRegistration().then(found => window.found = found) && window.found && !window.found.installing"), Is.True);

        Assert.That(_browser.Get<bool>("Boolean(window.found.waiting)"), Is.False);
        Visit(_page, Kept);
        Assert.That(Version(), Is.EqualTo("undefined"));
    }

    private void Visit(string address, string ready) => _browser.Visit(address, ready, Patience);

    private bool Becomes(string expression) => _browser.Becomes(expression, Patience);

    private string Version() => _browser.Get<string>("String(document.documentElement.dataset.site)");

    // the same site with another name
    private void Publish(string name, bool withPage = true)
    {
        string page = _folder.File("lab/index.html"), worker = _folder.File("lab/service-worker.js");
        string before = File.ReadAllText(page), after = before.Replace("<html ", $"<html data-site=\"{name}\" ", StringComparison.Ordinal);
        Assert.That(after, Is.Not.EqualTo(before));
        if (withPage)
            File.WriteAllText(page, after);

        Assert.That(File.ReadAllText(worker), Does.Contain(Hash(before)));
        string script = File.ReadAllText(worker).Replace(Hash(before), Hash(after), StringComparison.Ordinal);
        File.WriteAllText(worker, script.Replace("version:\"", $"version:\"{name}-", StringComparison.Ordinal));

        static string Hash(string text) => Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(text)));
    }
}
