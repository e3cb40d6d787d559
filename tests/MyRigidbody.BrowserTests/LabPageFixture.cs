using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Tests of the lab in a browser, which remembers nothing of other tests at their start.</summary>
public abstract class LabPageFixture : BrowserFixture
{
    private protected static LabSite Site => Shared.Site;

    /// <summary>What the page has kept goes; a style sheet has the site's storage, and keeps nothing itself.</summary>
    [OneTimeSetUp]
    public void Forget()
    {
        Browser.Visit(Site.Address + "page.css", "true");
        Browser.Do("localStorage.clear(); sessionStorage.clear()");
    }
}
