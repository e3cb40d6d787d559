using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Slow to start, so started once: a browser, and a server of the site.</summary>
[SetUpFixture]
public sealed class Shared
{
    private static Browser? _browser;
    private static LabSite? _site;

    /// <summary>The browser; tests are skipped where there is none.</summary>
    internal static Browser Browser => _browser ??= new Browser();

    /// <summary>The site, at one address, so that one service worker keeps its files once; tests are skipped where it is not built.</summary>
    internal static LabSite Site => _site ??= new LabSite();

    /// <summary>Ends both, after the last test.</summary>
    [OneTimeTearDown]
    public void Stop()
    {
        _browser?.Dispose();
        _site?.Dispose();
    }
}
