#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>A number of each of several bodies in twice the digits: the operations of <see cref="DoubleDouble"/>, in the same order.</summary>
    internal struct LongLanes
    {
        public Lanes High;
        public Lanes Low;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public LongLanes(Lanes high, Lanes low)
        {
            High = high + low;
            Low = low - (High - high);
        }

        /// <summary>The same number for all bodies.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static implicit operator LongLanes(DoubleDouble x) => new LongLanes(new Lanes(x.High), new Lanes(x.Low));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static implicit operator LongLanes(double x) => new LongLanes(new Lanes(x), Lanes.Zero);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static LongLanes operator +(LongLanes a, LongLanes b)
        {
            Lanes sum = a.High + b.High;
            return new LongLanes(sum, Lost(a.High, b.High, sum) + (a.Low + b.Low));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static LongLanes operator -(LongLanes a, LongLanes b) => a + new LongLanes(-b.High, -b.Low);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static LongLanes operator *(LongLanes a, LongLanes b)
        {
            Lanes product = a.High * b.High;
            return new LongLanes(product, LostOf(a.High, b.High, product) + (a.High * b.Low + a.Low * b.High));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Lanes Lost(Lanes a, Lanes b, Lanes sum)
        {
            Lanes back = sum - a;
            return (a - (sum - back)) + (b - back);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Lanes LostOf(Lanes a, Lanes b, Lanes product)
        {
            Lanes a1 = Upper(a), a2 = a - a1, b1 = Upper(b), b2 = b - b1;
            return ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Lanes Minor(Lanes a, Lanes aLow, Lanes b, Lanes bLow, Lanes c, Lanes cLow, Lanes d, Lanes dLow, out Lanes low)
        {
            Lanes ab = a * b, cd = c * d, all = ab - cd;
            low = ((LostOf(a, b, ab) - LostOf(c, d, cd)) + Lost(ab, -cd, all)) + ((a * bLow + aLow * b) - (c * dLow + cLow * d));
            return all;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Lanes Add(Lanes sum, Lanes sumLow, Lanes a, Lanes aLow, Lanes b, Lanes bLow, out Lanes low)
        {
            Lanes ab = a * b, all = ab + sum;
            low = (LostOf(a, b, ab) + Lost(ab, sum, all)) + ((a * bLow + aLow * b) + sumLow);
            return all;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Lanes Upper(Lanes x) => Vector.AsVectorDouble(Vector.AsVectorInt64(x) & new Masks(DoubleDouble.UpperHalf));
    }

    /// <summary>A rotation of each of several bodies in twice the digits: the operations of <see cref="Quaterniondd"/>, in the same order.</summary>
    internal struct LongTurnLanes
    {
        public LongLanes W, X, Y, Z;

        public LongTurnLanes(in Group bodies, int q, int lost)
        {
            W = new LongLanes(bodies[q], bodies[lost]);
            X = new LongLanes(bodies[q + 1], bodies[lost + 1]);
            Y = new LongLanes(bodies[q + 2], bodies[lost + 2]);
            Z = new LongLanes(bodies[q + 3], bodies[lost + 3]);
        }

        public QuaternionLanes Rounded => new QuaternionLanes(W.High, X.High, Y.High, Z.High);

        /// <summary>Takes a vector of each body to the world.</summary>
        [MethodImpl(Kernel.Compiled)]
        public void Rotate(ref LongLanes first, ref LongLanes second, ref LongLanes third)
        {
            Lanes w = W.High, x = X.High, y = Y.High, z = Z.High, wl = W.Low, xl = X.Low, yl = Y.Low, zl = Z.Low;
            Lanes a = first.High, b = second.High, c = third.High, al = first.Low, bl = second.Low, cl = third.Low;
            Lanes d = LongLanes.Minor(y, yl, c, cl, z, zl, b, bl, out Lanes dl), ta = LongLanes.Add(d, dl, w, wl, a, al, out Lanes tal);
            Lanes e = LongLanes.Minor(z, zl, a, al, x, xl, c, cl, out Lanes el), tb = LongLanes.Add(e, el, w, wl, b, bl, out Lanes tbl);
            Lanes f = LongLanes.Minor(x, xl, b, bl, y, yl, a, al, out Lanes fl), tc = LongLanes.Add(f, fl, w, wl, c, cl, out Lanes tcl);
            d = LongLanes.Minor(y, yl, tc, tcl, z, zl, tb, tbl, out dl);
            e = LongLanes.Minor(z, zl, ta, tal, x, xl, tc, tcl, out el);
            f = LongLanes.Minor(x, xl, tb, tbl, y, yl, ta, tal, out fl);
            Lanes n = LongLanes.Minor(x, xl, x, xl, -y, -yl, y, yl, out Lanes nl), m = LongLanes.Minor(w, wl, w, wl, -z, -zl, z, zl, out Lanes ml);
            Lanes all = m + n, off = (all - Lanes.One) + (LongLanes.Lost(m, n, all) + (nl + ml));
            first += new LongLanes(2 * d, 2 * (dl - off * d));
            second += new LongLanes(2 * e, 2 * (el - off * e));
            third += new LongLanes(2 * f, 2 * (fl - off * f));
        }

        /// <summary>This rotation after another, which all bodies share.</summary>
        [MethodImpl(Kernel.Compiled)]
        public void After(in Quaterniondd first)
        {
            LongLanes w = W, x = X, y = Y, z = Z, fw = first.W, fx = first.Vector.X, fy = first.Vector.Y, fz = first.Vector.Z;
            W = w * fw - (x * fx + y * fy + z * fz);
            X = w * fx + fw * x + (y * fz - z * fy);
            Y = w * fy + fw * y + (z * fx - x * fz);
            Z = w * fz + fw * z + (x * fy - y * fx);
        }
    }

    internal readonly partial struct PrincipalAxesOrder
    {
        /// <summary>The orientations of bodies, from quaternions that take principal axes to world axes, both in this order.</summary>
        public void ToBody(ref LongTurnLanes q)
        {
            (q.X, q.Y, q.Z) = Last == 0 ? (q.X, q.Y, q.Z) : Last == 1 ? (q.Y, q.Z, q.X) : (q.Z, q.X, q.Y);
            if (_isTurned)
                q.After(Frame.Conjugate);
        }

        /// <summary>Vectors in world axes, from vectors in world axes in this order.</summary>
        public VectorLanes ToWorld(VectorLanes v) =>
            Last == 0 ? v : Last == 1 ? new VectorLanes(v.Y, v.Z, v.X) : new VectorLanes(v.Z, v.X, v.Y);
    }
}
#endif
