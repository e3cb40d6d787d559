using System.Numerics;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// Elementary functions to 256 bits by their series in whole numbers. Shares no constant and no step with the
/// library's own.
/// </summary>
internal static class ManyDigits
{
    private const int MostBits = 1600;
    private static readonly BigInteger PiDigits = 16 * InverseTangent(5) - 4 * InverseTangent(239);
    private static readonly BigInteger Ln2Digits = 2 * InverseTangentHyperbolic(3);

    /// <summary>π with the given number of binary places.</summary>
    public static BigInteger Pi(int bits) => PiDigits >> (MostBits - bits);

    /// <summary>sin x and cos x.</summary>
    public static (Fixed Sin, Fixed Cos) SinCos(double x)
    {
        Fixed given = Fixed.Of(x);
        // enough places for a tiny x, and for a huge one that lies close to a multiple of π/2
        int bits = Fixed.Bits + 64 + Math.Max(0, given.Scale);
        BigInteger r = given.To(bits).Mantissa, halfPi = Pi(bits) >> 1;
        BigInteger n = Round(r, halfPi);
        r -= n * halfPi;
        (BigInteger sin, BigInteger cos) = ((int)(n & 3)) switch
        {
            0 => (Alternating(r, bits, 1), Alternating(r, bits, 0)),
            1 => (Alternating(r, bits, 0), -Alternating(r, bits, 1)),
            2 => (-Alternating(r, bits, 1), -Alternating(r, bits, 0)),
            _ => (-Alternating(r, bits, 0), Alternating(r, bits, 1)),
        };
        return (new Fixed(sin, bits), new Fixed(cos, bits));
    }

    /// <summary>e^x.</summary>
    public static Fixed Exp(double x)
    {
        Fixed given = Fixed.Of(x);
        int bits = Fixed.Bits + 64 + Math.Max(0, Math.Min(given.Scale, Fixed.Bits));
        BigInteger r = given.To(bits).Mantissa, ln2 = Ln2Digits >> (MostBits - bits);
        BigInteger n = Round(r, ln2);
        r -= n * ln2;
        BigInteger term = BigInteger.One << bits, sum = 0;
        for (int k = 1; !term.IsZero; k++)
        {
            sum += term;
            term = (term * r >> bits) / k;
        }

        return new Fixed(sum, bits - (int)n);
    }

    /// <summary>φ₁(z) = (1 − e^(−z))/z.</summary>
    public static Fixed Phi1(double z) => z < 1 ? PhiSeries(z, 1) : Quotient(One - ExpOfMinus(z), z, 1);

    /// <summary>φ₂(z) = (z − 1 + e^(−z))/z².</summary>
    public static Fixed Phi2(double z) => z < 1 ? PhiSeries(z, 2) : Quotient(Fixed.Of(z).To(Wide).Mantissa - One + ExpOfMinus(z), z, 2);

    private const int Wide = 1400;

    private static BigInteger One => BigInteger.One << Wide;

    private static BigInteger ExpOfMinus(double z) => z > 2000 ? 0 : Exp(-z).To(Wide).Mantissa;

    private static Fixed Quotient(BigInteger numerator, double z, int power)
    {
        Fixed divisor = Fixed.Of(z);
        BigInteger d = BigInteger.Pow(divisor.Mantissa, power);
        return new Fixed((numerator << Wide) / d, 2 * Wide - power * divisor.Scale);
    }

    // Σ (−z)^k / (k + n)!
    private static Fixed PhiSeries(double z, int n)
    {
        const int bits = Fixed.Bits;
        BigInteger argument = Fixed.Of(z).To(bits).Mantissa, term = (BigInteger.One << bits) / n, sum = 0;
        for (int k = 1; !term.IsZero; k++)
        {
            sum += term;
            term = -(term * argument) / ((BigInteger.One << bits) * (k + n));
        }

        return new Fixed(sum, bits);
    }

    // r^first/first! − r^(first+2)/(first+2)! + ...
    private static BigInteger Alternating(BigInteger r, int bits, int first)
    {
        BigInteger square = r * r >> bits, term = first == 0 ? BigInteger.One << bits : r, sum = 0;
        for (int k = first + 2; !term.IsZero; k += 2)
        {
            sum += term;
            term = -(term * square) / ((BigInteger)(k * (k - 1)) << bits);
        }

        return sum;
    }

    private static BigInteger Round(BigInteger a, BigInteger b) => BigInteger.Divide(2 * a + (a.Sign < 0 ? -b : b), 2 * b);

    private static BigInteger InverseTangent(int inverse) => Series(inverse, alternating: true);

    private static BigInteger InverseTangentHyperbolic(int inverse) => Series(inverse, alternating: false);

    // Σ (±1)^k / ((2k + 1) n^(2k + 1))
    private static BigInteger Series(int n, bool alternating)
    {
        const int spare = 32;
        BigInteger power = (BigInteger.One << MostBits + spare) / n, sum = 0;
        for (int k = 0; !power.IsZero; k++)
        {
            BigInteger term = power / (2 * k + 1);
            sum += alternating && k % 2 == 1 ? -term : term;
            power /= n * n;
        }

        return sum >> spare;
    }
}
