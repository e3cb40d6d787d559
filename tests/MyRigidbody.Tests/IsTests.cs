using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class IsTests
{
    [Test]
    public void What_is_no_number_is_below_no_bound()
    {
        Assert.That(() => Assert.That(double.NaN, Is.LessThan(1e300)), Throws.InstanceOf<AssertionException>());
        Assert.That(() => Assert.That(double.NaN, Is.LessThanOrEqualTo(1e300)), Throws.InstanceOf<AssertionException>());
        Assert.That(() => Assert.That(double.NaN, Is.LessThan(1e300).And.GreaterThan(0)), Throws.InstanceOf<AssertionException>());
        Assert.That(() => Assert.That(2.0, Is.LessThan(1)), Throws.InstanceOf<AssertionException>());
        Assert.That(1.0, Is.LessThan(2).And.GreaterThan(0));
        Assert.That(1L, Is.LessThanOrEqualTo(1));
        // the one it stands in for
        Assert.That(double.NaN, NUnit.Framework.Is.LessThan(1));
    }
}
