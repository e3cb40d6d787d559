using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Where the reduced argument decides: beyond all exponents, and beside multiples of π/2.</summary>
public sealed class ElementaryEdgeTests
{
    [Test]
    public void Exponential_is_zero_far_below_and_infinite_far_above()
    {
        foreach (double x in new[] { 1099, 1100, 1101, 1e4, 1e300, double.PositiveInfinity })
            Assert.That((Elementary.Exp(-x), Elementary.Exp(x)), Is.EqualTo((0.0, double.PositiveInfinity)));
        Assert.That(Elementary.Exp(double.NaN), Is.NaN);
    }

    [TestCase(1, 3)]
    [TestCase(1e3, 1e4)]
    [TestCase(1e7, 8e8)]
    public void Sine_and_cosine_are_within_three_quarters_of_the_last_place(double from, double to)
    {
        Random random = new(1);
        double worst = 0;
        for (int i = 0; i < 1000; i++)
        {
            double x = from + (to - from) * random.NextDouble();
            (Fixed sin, Fixed cos) = ManyDigits.SinCos(x);
            worst = Math.Max(worst, Math.Max(sin.UlpsTo(Elementary.Sin(x)), cos.UlpsTo(Elementary.Cos(x))));
        }

        Assert.That(worst, Is.LessThan(0.75)); // measured at most 0.707
    }
}
