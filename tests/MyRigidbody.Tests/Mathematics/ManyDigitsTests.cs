using System.Globalization;
using System.Numerics;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The reference functions themselves, against digits from printed tables.</summary>
public sealed class ManyDigitsTests
{
    [Test]
    public void Pi_has_the_digits_of_any_table() => Assert.That(
        Decimal(new Fixed(ManyDigits.Pi(300), 300)), Is.EqualTo("314159265358979323846264338327950288419716939937510"));

    [Test]
    public void Sine_and_cosine_of_one_have_the_digits_of_any_table()
    {
        (Fixed sin, Fixed cos) = ManyDigits.SinCos(1);
        Assert.That(Decimal(sin), Is.EqualTo("84147098480789650665250232163029899962256306079837"));
        Assert.That(Decimal(cos), Is.EqualTo("54030230586813971740093660744297660373231042061792"));
    }

    [Test]
    public void Exponential_of_one_has_the_digits_of_any_table() => Assert.That(
        Decimal(ManyDigits.Exp(1)), Is.EqualTo("271828182845904523536028747135266249775724709369995"));

    [Test]
    public void Phi_of_one_follows_from_e()
    {
        // φ₁(1) = 1 − 1/e, φ₂(1) = 1/e; just below 1 the series must go on where the quotient ends
        Assert.That(Decimal(ManyDigits.Phi1(1)), Is.EqualTo("63212055882855767840447622983853913255418886896823"));
        Assert.That(Decimal(ManyDigits.Phi2(1)), Is.EqualTo("36787944117144232159552377016146086744581113103176"));
        Assert.That(ManyDigits.Phi1(1).DistanceTo(ManyDigits.Phi1(Math.BitDecrement(1)).ToDouble()), Is.LessThan(2e-16)); // measured 1.2e-17
        Assert.That(ManyDigits.Phi2(1).DistanceTo(ManyDigits.Phi2(Math.BitDecrement(1)).ToDouble()), Is.LessThan(2e-16)); // measured 4.3e-17
    }

    [Test]
    public void Distance_is_counted_in_units_in_the_last_place()
    {
        Assert.That(Fixed.Of(1).UlpsTo(1), Is.Zero);
        Assert.That(Fixed.Of(1).UlpsTo(Math.BitIncrement(1)), Is.EqualTo(1));
        Assert.That(Fixed.Of(1).UlpsTo(Math.BitDecrement(1)), Is.EqualTo(0.5));
        Assert.That(Fixed.Of(-3e-310).UlpsTo(-3e-310 + 5 * double.Epsilon), Is.EqualTo(5));
        Assert.That(new Fixed(3, 1).UlpsTo(1), Is.EqualTo(Math.Pow(2, 51)));
        Assert.That(new Fixed(0, 0).UlpsTo(-double.Epsilon), Is.EqualTo(1));
    }

    // 50 digits behind the point, without it
    private static string Decimal(Fixed value) =>
        Fixed.Shift(value.Mantissa * BigInteger.Pow(10, 50), -value.Scale).ToString(CultureInfo.InvariantCulture);
}
