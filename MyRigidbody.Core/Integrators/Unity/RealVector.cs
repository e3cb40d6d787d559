using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A vector of precision R; products and sums from left to right, as PhysX writes them.</summary>
    internal struct RealVector<R> where R : struct, IRounding
    {
        public Real<R> X, Y, Z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealVector(Real<R> x, Real<R> y, Real<R> z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public bool IsZero => X.IsZero && Y.IsZero && Z.IsZero;

        public Real<R> LengthSquared => Dot(this);

        public static RealVector<R> From(Vector3d v) => new RealVector<R>(v.X, v.Y, v.Z);

        public Vector3d ToDouble() => new Vector3d((double)X, (double)Y, (double)Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RealVector<R> operator +(RealVector<R> a, RealVector<R> b) =>
            new RealVector<R>(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RealVector<R> operator -(RealVector<R> a, RealVector<R> b) =>
            new RealVector<R>(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static RealVector<R> operator -(RealVector<R> a) => new RealVector<R>(-a.X, -a.Y, -a.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static RealVector<R> operator *(RealVector<R> a, Real<R> s) => new RealVector<R>(a.X * s, a.Y * s, a.Z * s);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Real<R> Dot(RealVector<R> b) => X * b.X + Y * b.Y + Z * b.Z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealVector<R> Cross(RealVector<R> b) =>
            new RealVector<R>(Y * b.Z - Z * b.Y, Z * b.X - X * b.Z, X * b.Y - Y * b.X);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RealVector<R> Scale(RealVector<R> b) => new RealVector<R>(X * b.X, Y * b.Y, Z * b.Z);

        public RealVector<R> Inverse() => new RealVector<R>(1.0 / X, 1.0 / Y, 1.0 / Z);
    }
}
