namespace RigidBodyDynamics
{
    /// <summary>A rotation in twice the digits (<see cref="DoubleDouble"/>): for starts, and for states that are read.</summary>
    internal readonly struct Quaterniondd
    {
        public readonly DoubleDouble W;
        public readonly Vector3dd Vector;

        public Quaterniondd(DoubleDouble w, Vector3dd vector)
        {
            W = w;
            Vector = vector;
        }

        /// <summary>A quaternion and its rounding error.</summary>
        public Quaterniondd(Quaterniond q, Quaterniond lost) : this(new DoubleDouble(q.W, lost.W), new Vector3dd(q.Vector, lost.Vector)) { }

        /// <summary>The nearest quaternion in double.</summary>
        public Quaterniond Rounded => new Quaterniond(W.High, Vector.Rounded);

        /// <summary>The rounding error of <see cref="Rounded"/>.</summary>
        public Quaterniond Lost => new Quaterniond(W.Low, Vector.Lost);

        public Quaterniondd Conjugate => new Quaterniondd(W, -1 * Vector);

        /// <summary>The quaternion of length 1 in the same direction, in twice the digits.</summary>
        public Quaterniondd Normalized => 1 / DoubleDouble.Sqrt(LengthSquared) * this;

        private DoubleDouble LengthSquared => W * W + Vector3dd.Dot(Vector, Vector);

        /// <summary>The rotation that a quaternion of any length represents.</summary>
        public static Quaterniondd Unit(Quaterniond q) => new Quaterniondd(q.W, q.Vector).Normalized;

        /// <summary>The rotation at a rate (rad/s) over a time (s), any number of revolutions.</summary>
        public static Quaterniondd Of(Vector3dd rate, DoubleDouble time)
        {
            DoubleDouble length = DoubleDouble.Sqrt(Vector3dd.Dot(rate, rate));
            if (length.High == 0)
                return new Quaterniondd(1, Vector3d.Zero);

            DoubleDouble half = 0.5 * time * length;
            Elementary.SinCos(half.High, out double sin, out double cos);
            return new Quaterniondd((DoubleDouble)cos - half.Low * sin, ((DoubleDouble)sin + half.Low * cos) / length * rate);
        }

        public static Quaterniondd operator *(DoubleDouble s, Quaterniondd a) => new Quaterniondd(s * a.W, s * a.Vector);

        public static Quaterniondd operator *(Quaterniondd a, Quaterniondd b) => new Quaterniondd(
            a.W * b.W - Vector3dd.Dot(a.Vector, b.Vector), a.W * b.Vector + b.W * a.Vector + Vector3dd.Cross(a.Vector, b.Vector));

        /// <summary>
        /// Takes a vector of the body to the world: v + 2u × (w v + u × v)/|q|², for a length that differs from 1 by roundings. Without
        /// structs, and with the rounding errors summed in one double: it runs whenever a state is read.
        /// </summary>
        public Vector3dd Rotate(in Vector3dd v)
        {
            double w = W.High, x = Vector.X.High, y = Vector.Y.High, z = Vector.Z.High, wl = W.Low, xl = Vector.X.Low, yl = Vector.Y.Low, zl = Vector.Z.Low;
            double a = v.X.High, b = v.Y.High, c = v.Z.High, al = v.X.Low, bl = v.Y.Low, cl = v.Z.Low;
            double d = DoubleDouble.Minor(y, yl, c, cl, z, zl, b, bl, out double dl), ta = DoubleDouble.Add(d, dl, w, wl, a, al, out double tal);
            double e = DoubleDouble.Minor(z, zl, a, al, x, xl, c, cl, out double el), tb = DoubleDouble.Add(e, el, w, wl, b, bl, out double tbl);
            double f = DoubleDouble.Minor(x, xl, b, bl, y, yl, a, al, out double fl), tc = DoubleDouble.Add(f, fl, w, wl, c, cl, out double tcl);
            d = DoubleDouble.Minor(y, yl, tc, tcl, z, zl, tb, tbl, out dl);
            e = DoubleDouble.Minor(z, zl, ta, tal, x, xl, tc, tcl, out el);
            f = DoubleDouble.Minor(x, xl, tb, tbl, y, yl, ta, tal, out fl);

            // |q|² − 1
            double n = DoubleDouble.Minor(x, xl, x, xl, -y, -yl, y, yl, out double nl), m = DoubleDouble.Minor(w, wl, w, wl, -z, -zl, z, zl, out double ml);
            double all = m + n, off = (all - 1) + (DoubleDouble.Lost(m, n, all) + (nl + ml));
            return new Vector3dd(
                v.X + new DoubleDouble(2 * d, 2 * (dl - off * d)), v.Y + new DoubleDouble(2 * e, 2 * (el - off * e)), v.Z + new DoubleDouble(2 * f, 2 * (fl - off * f)));
        }
    }
}
