using System.Numerics;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Twice the digits, against whole numbers of 400 bits.</summary>
public sealed class DoubleDoubleTests
{
    private const int Scale = 400;

    // 2^-104 is 4.9e-32
    [Test]
    public void Sums_products_quotients_and_roots_have_thirty_one_digits()
    {
        Random random = new(5);
        double worst = 0;
        for (int i = 0; i < 20_000; i++)
        {
            DoubleDouble a = Any(), b = Any();
            BigInteger x = Of(a), y = Of(b), size = BigInteger.Abs(x) + BigInteger.Abs(y);
            Look(a + b, x + y, size);
            Look(a - b, x - y, size);
            Look(a * b, x * y >> Scale, x * y >> Scale);
            Look(a / b, (x << Scale) / y, (x << Scale) / y);
            DoubleDouble root = DoubleDouble.Sqrt(a * a);
            Look(root, BigInteger.Abs(x), x);
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2}"));
        Assert.That(worst, Is.LessThan(2e-31)); // measured 5.3e-32

        DoubleDouble Any()
        {
            double high = Math.ScaleB(random.NextDouble() - 0.5, random.Next(-40, 40));
            return new DoubleDouble(high, (random.NextDouble() - 0.5) * Math.ScaleB(high, -53));
        }

        void Look(DoubleDouble found, BigInteger right, BigInteger of) =>
            worst = Math.Max(worst, Math.Exp(BigInteger.Log(BigInteger.Abs(Of(found) - right) + 1) - BigInteger.Log(BigInteger.Abs(of) + 1)));
    }

    [Test]
    public void Products_of_the_largest_numbers_do_not_overflow_on_the_way()
    {
        DoubleDouble product = (DoubleDouble)1.7e308 * 0.99;
        Assert.That(product.High, Is.EqualTo(1.7e308 * 0.99));
        Assert.That(product.Low, Is.Not.NaN);
    }

    [TestCase(0.3, 1e-6)]
    [TestCase(0.3, 10)]
    [TestCase(0.04, 1e4)]
    [TestCase(2, -3)]
    public void Time_of_a_damped_turn_has_more_digits_than_a_double(double rate, double time)
    {
        DoubleDouble found = Drift.TurningTimeOf(rate, time), z = (DoubleDouble)rate * time;
        // the series of (1 − e^(−z))/z from its definition, in whole numbers
        BigInteger one = BigInteger.One << Scale, x = Of(z), term = one, sum = 0;
        for (int k = 1; !term.IsZero && k < 3000; k++)
        {
            term = -(term * x >> Scale) / k;
            sum -= term;
        }

        BigInteger right = (sum << Scale) / Of(rate);
        TestContext.Out.WriteLine(FormattableString.Invariant($"off {Math.Abs((double)(Of(found) - right) / (double)right):g2}"));
        Assert.That(Math.Abs((double)(Of(found) - right) / (double)right), Is.LessThan(1e-28)); // measured at most 1.9e-32
    }

    private static BigInteger Of(DoubleDouble a) => Fixed.Of(a.High).To(Scale).Mantissa + Fixed.Of(a.Low).To(Scale).Mantissa;
}
