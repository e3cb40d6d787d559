#if NET
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    public static partial class Elementary
    {
        /// <summary><see cref="SinCos(double, out double, out double)"/> for several numbers at once: the same operations in the same order.</summary>
        internal static void SinCosOf(Lanes x, out Lanes sin, out Lanes cos)
        {
            // only numbers this large need a division with remainder; it changes no bit of the others
            if (!Vector.LessThanOrEqualAll(Vector.Abs(x), new Lanes(LargestExactArgument)))
                x = Reduced(x);

            Lanes n = Vector.Floor(x * TwoOverPi + new Lanes(0.5));
            Lanes a = x - n * HalfPi1;
            Lanes b = n * HalfPi2;
            Lanes r1 = a - b;
            Lanes lost = TwoDifferenceError(a, b, r1);
            Lanes c = n * HalfPi3;
            Lanes r2 = r1 - c;
            lost += TwoDifferenceError(r1, c, r2);
            Lanes d = n * HalfPi4;
            Lanes r3 = r2 - d;
            lost += TwoDifferenceError(r2, d, r3);
            Lanes rest = lost - n * HalfPi5;
            Lanes r = r3 + rest;
            Lanes tail = (r3 - r) + rest;

            Lanes s = SinSeries(r, tail), k = CosSeries(r, tail), quarter = n - 4 * Vector.Floor(0.25 * n);
            Masks isFirst = Vector.Equals(quarter, Lanes.One), isSecond = Vector.Equals(quarter, new Lanes(2)), isThird = Vector.Equals(quarter, new Lanes(3));
            sin = Vector.ConditionalSelect(isFirst | isThird, k, s);
            cos = Vector.ConditionalSelect(isFirst | isThird, s, k);
            sin = Vector.ConditionalSelect(isSecond | isThird, -sin, sin);
            cos = Vector.ConditionalSelect(isFirst | isSecond, -cos, cos);
        }

        private static Lanes Reduced(Lanes x)
        {
            Lanes reduced = x;
            for (int i = 0; i < Lanes.Count; i++)
            {
                if (!(System.Math.Abs(x[i]) <= LargestExactArgument))
                    reduced = Vector.WithElement(reduced, i, x[i] % TwoPi);
            }

            return reduced;
        }

        private static Lanes TwoDifferenceError(Lanes a, Lanes b, Lanes difference)
        {
            Lanes back = difference - a;
            return (a - (difference - back)) - (b + back);
        }

        private static Lanes SinSeries(Lanes r, Lanes tail)
        {
            Lanes z = r * r;
            Lanes p = new Lanes(1.0 / 355687428096000);
            p = p * z - new Lanes(1.0 / 1307674368000);
            p = p * z + new Lanes(1.0 / 6227020800);
            p = p * z - new Lanes(1.0 / 39916800);
            p = p * z + new Lanes(1.0 / 362880);
            p = p * z - new Lanes(1.0 / 5040);
            p = p * z + new Lanes(1.0 / 120);
            p = p * z - new Lanes(1.0 / 6);
            return r + (p * z * r + tail * (Lanes.One - 0.5 * z));
        }

        private static Lanes CosSeries(Lanes r, Lanes tail)
        {
            Lanes z = r * r;
            Lanes p = new Lanes(-1.0 / 6402373705728000);
            p = p * z + new Lanes(1.0 / 20922789888000);
            p = p * z - new Lanes(1.0 / 87178291200);
            p = p * z + new Lanes(1.0 / 479001600);
            p = p * z - new Lanes(1.0 / 3628800);
            p = p * z + new Lanes(1.0 / 40320);
            p = p * z - new Lanes(1.0 / 720);
            p = p * z + new Lanes(1.0 / 24);
            Lanes half = 0.5 * z, whole = Lanes.One - half;
            return whole + (((Lanes.One - whole) - half) + (p * z * z - r * tail));
        }
    }
}
#endif
