using System.Globalization;
using System.Numerics;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class ElementaryTests
{
    private const int Count = 4000;
    private const double LargestExactArgument = 8.4e8;

    // each range with the same arguments in every run
    private static readonly object[] Angles =
    [
        new object[] { "up to 10", Uniform(1, -10, 10) },
        new object[] { "up to 1000", Uniform(2, -1000, 1000) },
        new object[] { "up to 8.4e8", Uniform(3, -LargestExactArgument, LargestExactArgument) },
        new object[] { "tiny", Logarithmic(4, -308, 0) },
        new object[] { "subnormal", new[] { 5e-324, -5e-324, 1e-310, 2.2e-308, -2.225e-308 } },
        new object[] { "of any size", Logarithmic(5, -10, 8.9) },
        new object[] { "beside multiples of pi/2", BesideMultiples(6) },
        new object[] { "as close to multiples of pi/2 as a double can be", ClosestToMultiples() },
    ];

    private static readonly object[] Powers =
    [
        new object[] { "from -745 to 709", Uniform(7, -745, 709) },
        new object[] { "with a subnormal result", Uniform(8, -745.1, -708.4) },
        new object[] { "at the upper end", Uniform(9, 709, 709.782712893384) },
        new object[] { "small", Uniform(10, -1, 1) },
        new object[] { "tiny", Logarithmic(11, -320, -1) },
        new object[] { "beside odd multiples of ln2/2", BesideHalfPowersOfTwo() },
    ];

    private static readonly object[] Products =
    [
        new object[] { "below 1", Uniform(12, 0, 1) },
        new object[] { "beside 1", Beside(1) },
        new object[] { "up to 50", Uniform(13, 1, 50) },
        new object[] { "of any size", Logarithmic(14, -320, 300).Select(Math.Abs).ToArray() },
    ];

    // promised is 1; held closer to what was measured, so that a correction that gets lost is noticed: sin 0.73, cos 0.73
    [TestCaseSource(nameof(Angles))]
    public void Sine_and_cosine_are_within_one_unit_in_the_last_place(string range, double[] arguments)
    {
        double sine = Worst(arguments, x => ManyDigits.SinCos(x).Sin.UlpsTo(Elementary.Sin(x)), "sin " + range);
        double cosine = Worst(arguments, x => ManyDigits.SinCos(x).Cos.UlpsTo(Elementary.Cos(x)), "cos " + range);
        Assert.That(sine, Is.LessThan(0.76));
        Assert.That(cosine, Is.LessThan(0.76));
    }

    [Test]
    public void SinCos_gives_the_bits_of_Sin_and_Cos()
    {
        foreach (double x in Uniform(15, -100, 100))
        {
            Elementary.SinCos(x, out double sin, out double cos);
            Assert.That((sin, cos), Is.EqualTo((Elementary.Sin(x), Elementary.Cos(x))));
        }
    }

    [Test]
    public void Beyond_the_exact_range_the_error_is_half_the_distance_to_the_next_double_times_the_slope()
    {
        double worst = Worst(
            Logarithmic(16, 8.93, 15),
            x =>
            {
                double half = 0.5 * (Math.BitIncrement(Math.Abs(x)) - Math.Abs(x));
                (Fixed sin, Fixed cos) = ManyDigits.SinCos(x);
                // a curve leaves its tangent by at most half the square; one rounding comes on top
                double beside = 0.5 * half * half + 1.2e-16;
                double sine = sin.DistanceTo(Elementary.Sin(x)) / (half * Math.Abs(cos.ToDouble()) + beside);
                double cosine = cos.DistanceTo(Elementary.Cos(x)) / (half * Math.Abs(sin.ToDouble()) + beside);
                return Math.Max(sine, cosine);
            },
            "part of the error that is allowed");
        Assert.That(worst, Is.LessThanOrEqualTo(1)); // measured 0.70
    }

    [TestCase(1e22)]
    [TestCase(-1e100)]
    [TestCase(double.MaxValue)]
    public void Sine_and_cosine_of_the_largest_numbers_lie_on_the_circle(double x)
    {
        Elementary.SinCos(x, out double sin, out double cos);
        Assert.That(sin * sin + cos * cos, Is.EqualTo(1).Within(4e-16)); // measured 2.2e-16
    }

    // promised is 1; measured 0.81
    [TestCaseSource(nameof(Powers))]
    public void Exponential_is_within_one_unit_in_the_last_place(string range, double[] arguments) => Assert.That(
        Worst(arguments, x => ManyDigits.Exp(x).UlpsTo(Elementary.Exp(x)), "exp " + range), Is.LessThan(0.84));

    // promised is 4; measured: phi1 1.03, phi2 1.62
    [TestCaseSource(nameof(Products))]
    public void Phi_functions_are_within_four_units_in_the_last_place(string range, double[] arguments)
    {
        double one = Worst(arguments, z => ManyDigits.Phi1(z).UlpsTo(Elementary.Phi1(z)), "phi1 " + range);
        double two = Worst(arguments, z => ManyDigits.Phi2(z).UlpsTo(Elementary.Phi2(z)), "phi2 " + range);
        Assert.That(one, Is.LessThan(1.5));
        Assert.That(two, Is.LessThan(2.5));
    }

    [Test]
    public void Where_the_result_is_exact_it_is_exact()
    {
        Assert.That(Elementary.Sin(0), Is.EqualTo(0));
        Assert.That(Elementary.Cos(0), Is.EqualTo(1));
        Assert.That(Elementary.Exp(0), Is.EqualTo(1));
        Assert.That(Elementary.Phi1(0), Is.EqualTo(1));
        Assert.That(Elementary.Phi2(0), Is.EqualTo(0.5));
    }

    [Test]
    public void Exponential_ends_in_zero_and_in_infinity()
    {
        Assert.That(Elementary.Exp(-746), Is.EqualTo(0));
        Assert.That(Elementary.Exp(-1e300), Is.EqualTo(0));
        Assert.That(Elementary.Exp(double.NegativeInfinity), Is.EqualTo(0));
        Assert.That(Elementary.Exp(-745), Is.EqualTo(double.Epsilon));
        Assert.That(Elementary.Exp(709.8), Is.EqualTo(double.PositiveInfinity));
        Assert.That(Elementary.Exp(1e300), Is.EqualTo(double.PositiveInfinity));
        Assert.That(Elementary.Exp(double.PositiveInfinity), Is.EqualTo(double.PositiveInfinity));
    }

    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(double.NegativeInfinity)]
    public void Sine_and_cosine_of_what_is_no_number_are_no_number(double x)
    {
        Assert.That(Elementary.Sin(x), Is.NaN);
        Assert.That(Elementary.Cos(x), Is.NaN);
    }

    [Test]
    public void Exponential_and_phi_of_NaN_are_NaN()
    {
        Assert.That(Elementary.Exp(double.NaN), Is.NaN);
        Assert.That(Elementary.Phi1(double.NaN), Is.NaN);
        Assert.That(Elementary.Phi2(double.NaN), Is.NaN);
    }

    private static double Worst(double[] arguments, Func<double, double> error, string what)
    {
        double worst = 0, at = arguments[0];
        foreach (double x in arguments)
        {
            double e = error(x);
            if (!(e <= worst))
                (worst, at) = (e, x);
        }

        TestContext.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}: {worst:f3} at {at:R}"));
        return worst;
    }

    private static double[] Uniform(int seed, double least, double most)
    {
        Random random = new(seed);
        return [.. Enumerable.Range(0, Count).Select(_ => least + (most - least) * random.NextDouble())];
    }

    // of either sign
    private static double[] Logarithmic(int seed, double leastDigits, double mostDigits)
    {
        Random random = new(seed);
        return [.. Uniform(seed, leastDigits, mostDigits).Select(d => (random.Next(2) == 0 ? -1 : 1) * Math.Pow(10, d))];
    }

    private static double[] Beside(double x) =>
        [x, Math.BitIncrement(x), Math.BitDecrement(x), x + 8 * (Math.BitIncrement(x) - x), x - 8 * (Math.BitIncrement(x) - x)];

    private static double[] BesideMultiples(int seed)
    {
        Random random = new(seed);
        IEnumerable<long> multiples = Enumerable.Range(1, 200).Select(n => (long)n)
            .Concat(Enumerable.Range(0, Count / 5).Select(_ => random.NextInt64(1, (long)(LargestExactArgument / 1.58))));
        return [.. multiples.SelectMany(n => Beside(new Fixed(n * ManyDigits.Pi(120), 121).ToDouble()))];
    }

    private static double[] BesideHalfPowersOfTwo() =>
        [.. Enumerable.Range(-1070, 2090).SelectMany(n => Beside((n + 0.5) * 0.6931471805599453)).Where(x => x < 709)];

    /// <summary>
    /// For every binade the doubles m·2^e that come closest to a multiple n·π/2: m/n is then a convergent of the
    /// continued fraction of π/2·2^-e.
    /// </summary>
    private static double[] ClosestToMultiples()
    {
        const int bits = 400;
        List<double> closest = [];
        for (int e = -52; e <= -23; e++)
        {
            BigInteger a = Fixed.Shift(ManyDigits.Pi(bits), -1 - e), b = BigInteger.One << bits;
            BigInteger m0 = 0, m1 = 1, n0 = 1, n1 = 0;
            while (b != 0 && m1 < BigInteger.One << 53)
            {
                BigInteger quotient = a / b;
                (a, b) = (b, a - quotient * b);
                (m0, m1) = (m1, quotient * m1 + m0);
                (n0, n1) = (n1, quotient * n1 + n0);
                double x = (double)m1 * Math.Pow(2, e);
                if (m1 < BigInteger.One << 53 && n1 > 0 && x > 1 && x <= LargestExactArgument)
                {
                    closest.Add(x);
                    closest.Add(-x);
                }
            }
        }

        return [.. closest];
    }
}
