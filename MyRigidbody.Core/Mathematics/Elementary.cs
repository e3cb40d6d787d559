using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Sine, cosine and exponential from + − × and bit patterns alone, because those of the runtimes may differ in
    /// the last bit. Argument reduction after Cody and Waite (Software Manual for the Elementary Functions, 1980),
    /// then Taylor's series for the remainder.
    /// </summary>
    public static partial class Elementary
    {
        // π/2 as a sum: four parts of 24 bits, whose product with a whole number below 2²⁹ is exact, and the rest. The
        // double closest to a multiple of π/2 is 2⁻⁶⁰ from it, so three parts and a rest would not suffice
        private const double HalfPi1 = 1.5707962512969970703125;
        private const double HalfPi2 = 7.5497894158615964e-8;
        private const double HalfPi3 = 5.3903025299577648e-15;
        private const double HalfPi4 = 3.282003415807913e-22;
        private const double HalfPi5 = 1.2706558760139879e-29;
        private const double TwoOverPi = 0.63661977236758134308;
        private const double TwoPi = 6.283185307179586476925;
        private const double LargestExactArgument = 8.4e8;

        // ln 2 as a sum: 32 bits, whose product with any exponent is exact, and the rest
        private const double Ln2High = 0.69314718036912382;
        private const double Ln2Low = 1.9082149292705877e-10;
        private const double OneOverLn2 = 1.44269504088896340736;

        /// <summary>Sine of x (rad), within 1 ulp for abs(x) up to 8.4e8; beyond, see <see cref="SinCos"/>.</summary>
        public static double Sin(double x)
        {
            SinCos(x, out double sin, out double _);
            return sin;
        }

        /// <summary>Cosine of x (rad), within 1 ulp for abs(x) up to 8.4e8; beyond, see <see cref="SinCos"/>.</summary>
        public static double Cos(double x)
        {
            SinCos(x, out double _, out double cos);
            return cos;
        }

        /// <summary>
        /// Both at once, each within 1 ulp for abs(x) up to 8.4e8. Beyond, the error is at most half the distance
        /// between x and the next double, times the slope. NaN for an infinite or undefined x.
        /// </summary>
        public static void SinCos(double x, out double sin, out double cos)
        {
            if (!(Math.Abs(x) <= LargestExactArgument))
            {
                // the remainder is exact for the double nearest to 2π, whose relative error is 3.9e-17
                x = x % TwoPi;
            }

            double n = Math.Floor(x * TwoOverPi + 0.5);
            // r + tail = x − n π/2: the first four products are exact, the sums keep their rounding errors
            double a = x - n * HalfPi1;
            double b = n * HalfPi2;
            double r1 = a - b;
            double lost = TwoDifferenceError(a, b, r1);
            double c = n * HalfPi3;
            double r2 = r1 - c;
            lost += TwoDifferenceError(r1, c, r2);
            double d = n * HalfPi4;
            double r3 = r2 - d;
            lost += TwoDifferenceError(r2, d, r3);
            double rest = lost - n * HalfPi5;
            double r = r3 + rest;
            double tail = (r3 - r) + rest;

            double s = SinSeries(r, tail), k = CosSeries(r, tail);
            switch ((long)n & 3)
            {
                case 0: sin = s; cos = k; break;
                case 1: sin = k; cos = -s; break;
                case 2: sin = -s; cos = -k; break;
                default: sin = -k; cos = s; break;
            }
        }

        /// <summary>e to the power x, within 1 ulp; 0 below about −745, infinite above about 709.8.</summary>
        public static double Exp(double x)
        {
            if (!(Math.Abs(x) < 1100))
                return x < 0 ? 0 : (x > 0 ? double.PositiveInfinity : x);

            double n = Math.Floor(x * OneOverLn2 + 0.5);
            double high = x - n * Ln2High, low = n * Ln2Low;
            double r = high - low, tail = (high - r) - low;
            // e^r − 1 − r by its series; r itself is added last, so that only its rounding error matters
            double r2 = r * r;
            double p = 1.0 / 6227020800;
            p = p * r + 1.0 / 479001600;
            p = p * r + 1.0 / 39916800;
            p = p * r + 1.0 / 3628800;
            p = p * r + 1.0 / 362880;
            p = p * r + 1.0 / 40320;
            p = p * r + 1.0 / 5040;
            p = p * r + 1.0 / 720;
            p = p * r + 1.0 / 120;
            p = p * r + 1.0 / 24;
            p = p * r + 1.0 / 6;
            p = p * r + 0.5;
            double value = 1 + (r + (p * r2 + (tail + tail * r)));
            // in two factors, because the exponent of a subnormal result is below that of any normal power of two
            int exponent = (int)n, half = exponent / 2;
            return value * PowerOfTwo(half) * PowerOfTwo(exponent - half);
        }

        /// <summary>φ₁(z) = (1 − e^(−z)) / z, within 4 ulp for z ≥ 0; φ₁(0) = 1.</summary>
        internal static double Phi1(double z) => Math.Abs(z) < 1 ? 1 - z * Phi2(z) : (1 - Exp(-z)) / z;

        /// <summary>φ₂(z) = (z − 1 + e^(−z)) / z², within 4 ulp for z ≥ 0; φ₂(0) = ½.</summary>
        internal static double Phi2(double z)
        {
            if (!(Math.Abs(z) < 1))
                return (1 - (1 - Exp(-z)) / z) / z;

            // Σ (−z)^k / (k + 2)!, from the smallest term
            double sum = 0;
            for (int k = 20; k >= 2; k--)
                sum = (1 - z * sum) / k;

            return sum;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double TwoDifferenceError(double a, double b, double difference)
        {
            // Knuth: a − b = difference + error, exactly
            double back = difference - a;
            return (a - (difference - back)) - (b + back);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double SinSeries(double r, double tail)
        {
            double z = r * r;
            double p = 1.0 / 355687428096000;
            p = p * z - 1.0 / 1307674368000;
            p = p * z + 1.0 / 6227020800;
            p = p * z - 1.0 / 39916800;
            p = p * z + 1.0 / 362880;
            p = p * z - 1.0 / 5040;
            p = p * z + 1.0 / 120;
            p = p * z - 1.0 / 6;
            return r + (p * z * r + tail * (1 - 0.5 * z));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double CosSeries(double r, double tail)
        {
            double z = r * r;
            double p = -1.0 / 6402373705728000;
            p = p * z + 1.0 / 20922789888000;
            p = p * z - 1.0 / 87178291200;
            p = p * z + 1.0 / 479001600;
            p = p * z - 1.0 / 3628800;
            p = p * z + 1.0 / 40320;
            p = p * z - 1.0 / 720;
            p = p * z + 1.0 / 24;
            double half = 0.5 * z, whole = 1 - half;
            // 1 − half is rounded; its rounding error is added with the remaining terms
            return whole + (((1 - whole) - half) + (p * z * z - r * tail));
        }

        private static double PowerOfTwo(int exponent) => BitConverter.Int64BitsToDouble((long)(exponent + 1023) << 52);
    }
}
