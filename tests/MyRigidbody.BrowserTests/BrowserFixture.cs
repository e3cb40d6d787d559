using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Tests of a page in Chromium, which is as good as new at their start, and in which nothing complains.</summary>
public abstract class BrowserFixture
{
    private protected static Browser Browser => Shared.Browser;

    /// <summary>What other tests have left goes.</summary>
    [OneTimeSetUp]
    public void Begin_anew() => Browser.Forget();

    /// <summary>A test that expects complaints reads them itself.</summary>
    [TearDown]
    public void Nothing_complains() => Assert.That(Browser.Complaints(), Is.Empty);
}
