using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A number in twice the digits, about 32: the unevaluated sum of two doubles. For constants that many steps use, and for
    /// motions over a million revolutions. Sources: T. J. Dekker, "A floating-point technique for extending the available
    /// precision", Numer. Math. 18 (1971); Y. Hida, X. S. Li, D. H. Bailey, "Algorithms for quad-double precision" (2001).
    /// </summary>
    internal readonly struct DoubleDouble
    {
        internal const long UpperHalf = -1L << 27;

        /// <summary>The number, rounded to double.</summary>
        public readonly double High;

        /// <summary>The rounding error of <see cref="High"/>.</summary>
        public readonly double Low;

        /// <summary>The sum of a number and a second one that is small beside it.</summary>
        public DoubleDouble(double high, double low)
        {
            High = high + low;
            Low = low - (High - high);
        }

        public static implicit operator DoubleDouble(double x) => new DoubleDouble(x, 0);

        public static DoubleDouble operator +(DoubleDouble a, DoubleDouble b)
        {
            double sum = a.High + b.High;
            return new DoubleDouble(sum, Lost(a.High, b.High, sum) + (a.Low + b.Low));
        }

        public static DoubleDouble operator -(DoubleDouble a) => new DoubleDouble(-a.High, -a.Low);

        public static DoubleDouble operator -(DoubleDouble a, DoubleDouble b) => a + -b;

        public static DoubleDouble operator *(DoubleDouble a, DoubleDouble b)
        {
            double product = a.High * b.High;
            return new DoubleDouble(product, LostOf(a.High, b.High, product) + (a.High * b.Low + a.Low * b.High));
        }

        public static DoubleDouble operator /(DoubleDouble a, DoubleDouble b)
        {
            double quotient = a.High / b.High;
            return new DoubleDouble(quotient, (a - quotient * b).High / b.High);
        }

        public static DoubleDouble Sqrt(DoubleDouble a)
        {
            double root = Math.Sqrt(a.High);
            return root == 0 ? root : new DoubleDouble(root, (a - (DoubleDouble)root * root).High / (2 * root));
        }

        /// <summary>The rounding error of a sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static double Lost(double a, double b, double sum) => (a - (sum - (sum - a))) + (b - (sum - a));

        /// <summary>The rounding error of a product.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static double LostOf(double a, double b, double product)
        {
            // halves of 26 bits, whose products are exact; split by a mask, which cannot overflow
            double a1 = Upper(a), a2 = a - a1, b1 = Upper(b), b2 = b - b1;
            return ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
        }

        /// <summary>a b − c d with its rounding error, without structs.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static double Minor(double a, double aLow, double b, double bLow, double c, double cLow, double d, double dLow, out double low)
        {
            double ab = a * b, cd = c * d, all = ab - cd;
            low = ((LostOf(a, b, ab) - LostOf(c, d, cd)) + Lost(ab, -cd, all)) + ((a * bLow + aLow * b) - (c * dLow + cLow * d));
            return all;
        }

        /// <summary>The sum of a number and a product, with its rounding error, without structs.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static double Add(double sum, double sumLow, double a, double aLow, double b, double bLow, out double low)
        {
            double ab = a * b, all = ab + sum;
            low = (LostOf(a, b, ab) + Lost(ab, sum, all)) + ((a * bLow + aLow * b) + sumLow);
            return all;
        }

        private static double Upper(double x) => BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(x) & UpperHalf);
    }
}
