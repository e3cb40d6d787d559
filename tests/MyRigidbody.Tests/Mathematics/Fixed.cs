using System.Numerics;

namespace RigidBodyDynamics.Tests;

/// <summary>The number Mantissa / 2^Scale: hundreds of bits, so that a double can be judged against it.</summary>
internal readonly record struct Fixed(BigInteger Mantissa, int Scale)
{
    /// <summary>Far more than the 53 bits of a double, after the worst cancellation that occurs here.</summary>
    public const int Bits = 256;

    /// <summary>Every double is a whole number of 2^-1074.</summary>
    private const int Subnormal = 1074;

    /// <summary>Exactly the double.</summary>
    public static Fixed Of(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int exponent = (int)(bits >> 52 & 0x7ff);
        long mantissa = bits & 0xfffffffffffff;
        if (exponent > 0)
            mantissa |= 1L << 52;
        else
            exponent = 1;
        return new Fixed(value < 0 ? -mantissa : mantissa, Subnormal + 1 - exponent);
    }

    /// <summary>The same number with another scale; digits beyond it are dropped.</summary>
    public Fixed To(int scale) => new(Shift(Mantissa, scale - Scale), scale);

    /// <summary>
    /// How far the double is from this number, in units in the last place of a double of this size; at the lower end
    /// that unit is 2^-1074.
    /// </summary>
    public double UlpsTo(double value)
    {
        const int fine = 40;
        int scale = Math.Max(Scale, Subnormal);
        BigInteger exact = To(scale).Mantissa, found = Of(value).To(scale).Mantissa;
        int topBit = (int)BigInteger.Abs(exact).GetBitLength() - 1 - scale;
        int ulp = Math.Max(topBit - 52, -Subnormal);
        return (double)Shift(BigInteger.Abs(exact - found), fine - (ulp + scale)) / (1L << fine);
    }

    /// <summary>How far the double is from this number.</summary>
    public double DistanceTo(double value)
    {
        BigInteger difference = BigInteger.Abs(To(Bits).Mantissa - Of(value).To(Bits).Mantissa);
        return (double)Shift(difference, 100 - Bits) / Math.Pow(2, 100);
    }

    /// <summary>The nearest double, or one beside it; for numbers of ordinary size.</summary>
    public double ToDouble() => (double)To(100).Mantissa / Math.Pow(2, 100);

    internal static BigInteger Shift(BigInteger value, int left) => left >= 0 ? value << left : value >> -left;
}
