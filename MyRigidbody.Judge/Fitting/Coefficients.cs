using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Least squares of a vector by one or two others.</summary>
    internal struct Coefficients
    {
        public double First { get; private set; }

        public double Second { get; private set; }

        public double Residual { get; private set; }

        /// <summary>The distance of one vector from the line of the other; where it is small the two coefficients cannot be separated.</summary>
        public double Spread { get; private set; }

        /// <summary>y ≈ First · a.</summary>
        public static Coefficients Of(Vector y, Vector a)
        {
            double first = Vector.Dot(y, a) / Vector.Dot(a, a);
            return new Coefficients { First = first, Residual = (y - first * a).Length, Spread = a.Length };
        }

        /// <summary>y ≈ First · a + Second · b.</summary>
        public static Coefficients Of(Vector y, Vector a, Vector b)
        {
            double aa = Vector.Dot(a, a), ab = Vector.Dot(a, b), bb = Vector.Dot(b, b), d = aa * bb - ab * ab;
            double ya = Vector.Dot(y, a), yb = Vector.Dot(y, b);
            double first = (ya * bb - yb * ab) / d, second = (yb * aa - ya * ab) / d;
            return new Coefficients
            {
                First = first,
                Second = second,
                Residual = (y - first * a - second * b).Length,
                Spread = Math.Sqrt(Math.Max(0, d / Math.Max(aa, bb))),
            };
        }

        public static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.Where(v => !double.IsNaN(v)).ToArray();
            Array.Sort(sorted);
            return sorted.Length == 0 ? double.NaN : sorted[sorted.Length / 2];
        }
    }
}
