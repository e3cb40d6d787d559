using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Tests of the lab in a browser, whose storage is empty at their start.</summary>
public abstract class LabPageFixture : BrowserFixture
{
    private protected static LabSite Site => Shared.Site;

    /// <summary>Clears what the page has stored; done in a style sheet, which has the site's storage and stores nothing itself.</summary>
    [OneTimeSetUp]
    public void Forget()
    {
        Browser.Visit(Site.Address + "page.css", "true");
        Browser.Do("localStorage.clear(); sessionStorage.clear()");
    }
}
