using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A quaternion of precision R, in PhysX's order of operations.</summary>
    internal struct RealQuaternion<R> where R : struct, IRounding
    {
        public Real<R> X, Y, Z, W;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealQuaternion(Real<R> x, Real<R> y, Real<R> z, Real<R> w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public RealQuaternion<R> Conjugate => new RealQuaternion<R>(-X, -Y, -Z, W);

        public RealQuaternion<R> Normalized
        {
            get
            {
                Real<R> s = 1.0 / (X * X + Y * Y + Z * Z + W * W).Sqrt();
                return Times(s);
            }
        }

        public static RealQuaternion<R> From(Quaterniond q) => new RealQuaternion<R>(q.X, q.Y, q.Z, q.W);

        public Quaterniond ToDouble() => new Quaterniond((double)W, (double)X, (double)Y, (double)Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RealQuaternion<R> operator +(RealQuaternion<R> a, RealQuaternion<R> b) =>
            new RealQuaternion<R>(a.X + b.X, a.Y + b.Y, a.Z + b.Z, a.W + b.W);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RealQuaternion<R> operator *(RealQuaternion<R> a, RealQuaternion<R> b) => new RealQuaternion<R>(
            a.W * b.X + b.W * a.X + a.Y * b.Z - b.Y * a.Z,
            a.W * b.Y + b.W * a.Y + a.Z * b.X - b.Z * a.X,
            a.W * b.Z + b.W * a.Z + a.X * b.Y - b.X * a.Y,
            a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealQuaternion<R> Times(Real<R> s) => new RealQuaternion<R>(X * s, Y * s, Z * s, W * s);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealVector<R> Rotate(RealVector<R> v) => Turn(v, W);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealVector<R> RotateInverse(RealVector<R> v) => Turn(v, -W);

        /// <summary>J v with J = R diag(d) Rᵀ, its lower half copied from its upper.</summary>
        public RealVector<R> TransformDiagonal(RealVector<R> d, RealVector<R> v)
        {
            Real<R> x2 = X + X, y2 = Y + Y, z2 = Z + Z;
            Real<R> xx = x2 * X, yy = y2 * Y, zz = z2 * Z;
            Real<R> xy = x2 * Y, xz = x2 * Z, xw = x2 * W, yz = y2 * Z, yw = y2 * W, zw = z2 * W;
            RealVector<R> r1 = new RealVector<R>(1.0 - yy - zz, xy - zw, xz + yw);
            RealVector<R> r2 = new RealVector<R>(xy + zw, 1.0 - xx - zz, yz - xw);
            RealVector<R> r3 = new RealVector<R>(xz - yw, yz + xw, 1.0 - xx - yy);
            RealVector<R> d1 = d.Scale(r1), d2 = d.Scale(r2), d3 = d.Scale(r3);
            Real<R> jxy = d1.Dot(r2), jxz = d1.Dot(r3), jyz = d2.Dot(r3);
            return new RealVector<R>(
                new RealVector<R>(d1.Dot(r1), jxy, jxz).Dot(v),
                new RealVector<R>(jxy, d2.Dot(r2), jyz).Dot(v),
                new RealVector<R>(jxz, jyz, d3.Dot(r3)).Dot(v));
        }

        // v (2w² − 1) + 2w (u × v) + 2u (u·v), u the vector part; the sign of w gives the rotation or its inverse
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private RealVector<R> Turn(RealVector<R> v, Real<R> w)
        {
            RealVector<R> u = new RealVector<R>(X, Y, Z), v2 = v * 2.0;
            Real<R> w2 = w * w - 0.5;
            return v2 * w2 + u.Cross(v2) * w + u * u.Dot(v2);
        }
    }
}
