using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Motions that break other programs are right, and the same assertions fail for weak integrators.</summary>
public sealed class HardCaseTests
{
    private static IEnumerable<TestCaseData> Holds =>
        from hard in HardCaseList.All
        from integrator in hard.Strong
        select new TestCaseData(hard.Name, integrator).SetName($"{hard.Name} by {integrator}");

    private static IEnumerable<TestCaseData> Breaks =>
        from hard in HardCaseList.All
        select new TestCaseData(hard.Name, hard.Weak).SetName($"{hard.Name} but not by {hard.Weak}");

    [TestCaseSource(nameof(Holds))]
    public void Holds_by(string name, string integrator)
    {
        HardCase hard = HardCaseList.Named(name);
        TestContext.Out.WriteLine(FormattableString.Invariant($"HARD {name} {integrator} {hard.By(integrator):g2}"));
        Assert.That(hard.By(integrator), Is.LessThan(hard.Bound));
    }

    [TestCaseSource(nameof(Breaks))]
    public void Breaks_by(string name, string integrator)
    {
        HardCase hard = HardCaseList.Named(name);
        TestContext.Out.WriteLine(FormattableString.Invariant($"WEAK {name} {integrator} {hard.By(integrator):g2}"));
        Assert.That(hard.By(integrator), Is.GreaterThanOrEqualTo(hard.WeakFrom));
        Assert.That(hard.By(integrator), Is.GreaterThanOrEqualTo(hard.Bound));
    }
}
