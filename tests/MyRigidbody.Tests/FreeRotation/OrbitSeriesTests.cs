using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// The constants of a step too short to be doubled, against their differential equations S' = c₁c₃, c₁' = −αSc₃,
/// c₃' = −βSc₁, ψ' = |L| (2T + A₁c₁ + A₃c₃)/(L² + I₁A₁c₁ + I₃A₃c₃), solved by power series in 28 digits.
/// </summary>
public sealed class OrbitSeriesTests
{
    private const int Terms = 20;

    // moments over the middle one, then A₁ and A₃, all of few bits; the last three reach α h² and β h² of 0.06²
    [TestCase(0.5, 1.25, 1, 1)]
    [TestCase(0.5, 1.25, 0.125, 1)]
    [TestCase(0.5, 1.25, 1, 0.125)]
    [TestCase(0.015625, 1.015625, 0.015625, 1)]
    [TestCase(0.015625, 1.015625, 0.015625, 0.0009765625)]
    [TestCase(0.015625, 1.015625, 0.0000152587890625, 1)]
    public void Constants_of_the_longest_step_by_series_have_all_digits(double i1, double i3, double a1, double a3)
    {
        TopShape shape = new(new Vector3d(i1, 1, i3), Quaterniond.Identity);
        double momentum = i1 * a1 + i3 * a3, fastest = (a1 + a3) * (a1 + a3) / momentum;
        fastest = Math.Max(fastest, Math.Max(shape.AlphaOfA3 * a3, shape.BetaOfA1 * a1));
        // a whole number of 2⁻²⁰ s, so that it is the same in both arithmetics
        double h = Math.Floor(0.0599 / Math.Sqrt(fastest) * (1 << 20)) / (1 << 20);
        OrbitStep step = default;
        step.Set(shape, a1, a3, shape.M1 * a1 / i1 - shape.M3 * a3 / i3, h);
        (decimal s, decimal v1, decimal v3, decimal sine, decimal versine) = Solved(Exact(i1), Exact(i3), Exact(a1), Exact(a3), Exact(h));
        TestContext.Out.WriteLine(FormattableString.Invariant(
            $"S {Off(step.S, s):g2}, V1 {Off(step.V1, v1):g2}, V3 {Off(step.V3, v3):g2}, sine {Off(step.Sine, sine):g2}, versine {Off(step.Versine, versine):g2}"));

        Assert.That(step.IsIllConditioned, Is.False);
        Assert.That(Off(step.S, s), Is.LessThan(4e-16)); // measured at most 4.6e-17
        // what the series leaves out is most where α = β: of 1 − c, but far below the last bit of c
        Assert.That(Off(step.V1, v1), Is.LessThan(1e-14)); // measured at most 5.6e-15, and 2.5e-16 elsewhere
        Assert.That(Off(step.V3, v3), Is.LessThan(1e-14)); // measured at most 5.5e-15, and 1.6e-16 elsewhere
        Assert.That(Math.Max(Off(step.V1, v1) * step.V1, Off(step.V3, v3) * step.V3), Is.LessThan(2e-17)); // measured at most 1.0e-17
        Assert.That((step.C1, step.C3), Is.EqualTo((1 - step.V1, 1 - step.V3)));
        Assert.That(Off(step.Sine, sine), Is.LessThan(4e-16)); // measured at most 2.2e-16
        Assert.That(Off(step.Versine, versine), Is.LessThan(8e-16)); // measured at most 4.0e-16
    }

    // three steps by series and three that are doubled, once, twice and four times
    [TestCase(0.01)]
    [TestCase(0.02)]
    [TestCase(0.03)]
    [TestCase(0.05)]
    [TestCase(0.1)]
    [TestCase(0.4)]
    public void Step_that_is_kept_knows_what_the_rounding_of_its_sine_took(double about)
    {
        TopShape shape = new(new Vector3d(0.25, 1, 1.25), Quaterniond.Identity);
        double h = Math.Floor(about * (1 << 20)) / (1 << 20), a1 = 1, a3 = 1.25;
        Vector3d w = new(2, 0, 1);
        OrbitStep step = default, once = default;
        step.Set(shape, a1, a3, shape.M1 * 4 - shape.M3, h, w, isKept: true);
        once.Set(shape, a1, a3, shape.M1 * 4 - shape.M3, h);
        decimal sine = Solved(0.25m, 1.25m, 1, 1.25m, Exact(h)).Sine;
        decimal found = Exact(step.Sine) * (1 + (decimal)step.SineLost);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{(double)(found / sine - 1):g2}, without {Off(once.Sine, sine):g2}"));
        Assert.That((double)Math.Abs(found / sine - 1), Is.LessThan(3e-17)); // measured at most 1.1e-17, where it is doubled
        Assert.That(once.SineLost, Is.Zero);
    }

    private static double Off(double found, decimal right) => Math.Abs((double)(Exact(found) / right - 1));

    // a cast keeps 15 digits only
    private static decimal Exact(double value)
    {
        int power = 52 - Math.ILogB(value);
        decimal exact = (long)Math.ScaleB(value, power);
        for (; power > 0; power--)
            exact /= 2;
        return exact;
    }

    /// <summary>S, 1 − c₁, 1 − c₃, sin(ψ/2)/|L| and 1 − cos(ψ/2).</summary>
    private static (decimal S, decimal V1, decimal V3, decimal Sine, decimal Versine) Solved(decimal i1, decimal i3, decimal a1, decimal a3, decimal h)
    {
        // α = (I₃ − I₁)(I₃ − 1)/(I₁ I₃) A₃ and β = (I₃ − I₁)(1 − I₁)/(I₁ I₃) A₁, in units of I₂; time in units of h
        decimal alpha = (i3 - i1) * (i3 - 1) / (i1 * i3) * a3 * h * h, beta = (i3 - i1) * (1 - i1) / (i1 * i3) * a1 * h * h;
        decimal[] s = new decimal[Terms], c1 = new decimal[Terms], c3 = new decimal[Terms], rate = new decimal[Terms];
        c1[0] = c3[0] = 1;
        for (int n = 0; n + 1 < Terms; n++)
        {
            s[n + 1] = Product(c1, c3, n) / (n + 1);
            c1[n + 1] = -alpha * Product(s, c3, n) / (n + 1);
            c3[n + 1] = -beta * Product(s, c1, n) / (n + 1);
        }

        // the quotient of two series, term by term
        decimal half = 0, energy = a1 + a3, momentum = i1 * a1 + i3 * a3;
        decimal[] below = [.. c1.Zip(c3, (x, y) => i1 * a1 * x + i3 * a3 * y)];
        below[0] += momentum;
        for (int n = 0; n < Terms; n++)
        {
            decimal above = (n == 0 ? energy : 0) + a1 * c1[n] + a3 * c3[n];
            rate[n] = (above - Product(below, rate, n)) / below[0];
            half += h * rate[n] / (n + 1) / 2;
        }

        // half is ψ/2 over |L|
        decimal square = momentum * half * half, sin = 0, cos = 0, term = half;
        for (int k = 1; k < 20; k += 2)
        {
            sin += term;
            cos += term * k / half;
            term *= -square / ((k + 1) * (k + 2));
        }

        return (h * s.Sum(), -c1.Skip(1).Sum(), -c3.Skip(1).Sum(), sin, 1 - cos);
    }

    private static decimal Product(decimal[] a, decimal[] b, int n)
    {
        decimal sum = 0;
        for (int k = 0; k <= n; k++)
            sum += a[k] * b[n - k];
        return sum;
    }
}
