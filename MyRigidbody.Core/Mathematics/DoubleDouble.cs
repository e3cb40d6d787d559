using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A number in twice the digits, about 32: the unevaluated sum of two doubles. For what is computed once and used for long:
    /// starts, and motions over a million turns. Sources: T. J. Dekker, "A floating-point technique for extending the available
    /// precision", Numer. Math. 18 (1971); Y. Hida, X. S. Li, D. H. Bailey, "Algorithms for quad-double precision" (2001).
    /// </summary>
    internal readonly struct DoubleDouble
    {
        private const long UpperHalf = -1L << 27;

        /// <summary>The number, rounded to double.</summary>
        public readonly double High;

        /// <summary>What that rounds away.</summary>
        public readonly double Low;

        /// <summary>The sum of a number and one that is small beside it.</summary>
        public DoubleDouble(double high, double low)
        {
            High = high + low;
            Low = low - (High - high);
        }

        public static implicit operator DoubleDouble(double x) => new DoubleDouble(x, 0);

        public static DoubleDouble operator +(DoubleDouble a, DoubleDouble b)
        {
            double sum = a.High + b.High, back = sum - a.High;
            double error = (a.High - (sum - back)) + (b.High - back);
            return new DoubleDouble(sum, error + (a.Low + b.Low));
        }

        public static DoubleDouble operator -(DoubleDouble a) => new DoubleDouble(-a.High, -a.Low);

        public static DoubleDouble operator -(DoubleDouble a, DoubleDouble b) => a + -b;

        public static DoubleDouble operator *(DoubleDouble a, DoubleDouble b)
        {
            // halves of 26 bits, whose products are exact; cut off by a mask, which cannot overflow
            double product = a.High * b.High, a1 = Upper(a.High), a2 = a.High - a1, b1 = Upper(b.High), b2 = b.High - b1;
            double error = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
            return new DoubleDouble(product, error + (a.High * b.Low + a.Low * b.High));
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

        private static double Upper(double x) => BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(x) & UpperHalf);
    }
}
