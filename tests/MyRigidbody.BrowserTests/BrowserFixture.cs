using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Tests of a page in Chromium, which is reset at their start, and in which the console stays empty.</summary>
public abstract class BrowserFixture
{
    private protected static Browser Browser => Shared.Browser;

    /// <summary>Resets what other tests have left.</summary>
    [OneTimeSetUp]
    public void Begin_anew() => Browser.Forget();

    /// <summary>A test that expects messages reads them itself.</summary>
    [TearDown]
    public void Nothing_complains() => Assert.That(Browser.Complaints(), Is.Empty);
}
