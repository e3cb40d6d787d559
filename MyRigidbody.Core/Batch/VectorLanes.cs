#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Numerics = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>How loops over lanes are compiled.</summary>
    internal static class Kernel
    {
        /// <summary>
        /// Optimised at the first call and not inlined: with a profile, the compiler does not inline into branches that were seldom
        /// taken, and everything passed to them by reference then lives in memory, which takes several times as long.
        /// </summary>
        public const MethodImplOptions Compiled = MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining;
    }

    /// <summary>A vector of each of several bodies: the operations of <see cref="Vector3d"/>, in the same order.</summary>
    internal struct VectorLanes
    {
        public Lanes X;
        public Lanes Y;
        public Lanes Z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public VectorLanes(Lanes x, Lanes y, Lanes z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>The same vector for all bodies.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public VectorLanes(Vector3d v)
        {
            X = new Lanes(v.X);
            Y = new Lanes(v.Y);
            Z = new Lanes(v.Z);
        }

        /// <summary>Reads three columns.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public VectorLanes(in Group bodies, int first)
        {
            X = bodies[first];
            Y = bodies[first + 1];
            Z = bodies[first + 2];
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Write(in Group bodies, int first)
        {
            bodies[first] = X;
            bodies[first + 1] = Y;
            bodies[first + 2] = Z;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes operator +(VectorLanes a, VectorLanes b) => new VectorLanes(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes operator -(VectorLanes a, VectorLanes b) => new VectorLanes(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes operator *(Lanes s, VectorLanes a) => new VectorLanes(s * a.X, s * a.Y, s * a.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes operator *(double s, VectorLanes a) => new Lanes(s) * a;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Lanes Dot(VectorLanes a, VectorLanes b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes Cross(VectorLanes a, VectorLanes b) =>
            new VectorLanes(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        /// <summary>The first where the mask says so, the second elsewhere.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes Choose(Masks where, VectorLanes a, VectorLanes b) => new VectorLanes(
            Numerics.ConditionalSelect(where, a.X, b.X), Numerics.ConditionalSelect(where, a.Y, b.Y), Numerics.ConditionalSelect(where, a.Z, b.Z));
    }

    /// <summary>A quaternion of each of several bodies: the operations of <see cref="Quaterniond"/>, in the same order.</summary>
    internal struct QuaternionLanes
    {
        public Lanes W;
        public Lanes X;
        public Lanes Y;
        public Lanes Z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public QuaternionLanes(Lanes w, Lanes x, Lanes y, Lanes z)
        {
            W = w;
            X = x;
            Y = y;
            Z = z;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public QuaternionLanes(Lanes w, VectorLanes v)
        {
            W = w;
            X = v.X;
            Y = v.Y;
            Z = v.Z;
        }

        /// <summary>Reads four columns.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public QuaternionLanes(in Group bodies, int first)
        {
            W = bodies[first];
            X = bodies[first + 1];
            Y = bodies[first + 2];
            Z = bodies[first + 3];
        }

        public VectorLanes Vector
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => new VectorLanes(X, Y, Z);
        }

        public Lanes LengthSquared
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => W * W + X * X + Y * Y + Z * Z;
        }

        public QuaternionLanes Normalized
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                Lanes s = Lanes.One / Numerics.SquareRoot(LengthSquared);
                return new QuaternionLanes(s * W, s * X, s * Y, s * Z);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Write(in Group bodies, int first)
        {
            bodies[first] = W;
            bodies[first + 1] = X;
            bodies[first + 2] = Y;
            bodies[first + 3] = Z;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static QuaternionLanes operator +(QuaternionLanes a, QuaternionLanes b) =>
            new QuaternionLanes(a.W + b.W, a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static QuaternionLanes operator *(Lanes s, QuaternionLanes a) => new QuaternionLanes(s * a.W, s * a.X, s * a.Y, s * a.Z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static QuaternionLanes operator *(QuaternionLanes a, QuaternionLanes b) => new QuaternionLanes(
            a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z,
            a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
            a.W * b.Y + a.Y * b.W + a.Z * b.X - a.X * b.Z,
            a.W * b.Z + a.Z * b.W + a.X * b.Y - a.Y * b.X);

        /// <summary>The first where the mask says so, the second elsewhere.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static QuaternionLanes Choose(Masks where, QuaternionLanes a, QuaternionLanes b) => new QuaternionLanes(
            Numerics.ConditionalSelect(where, a.W, b.W),
            Numerics.ConditionalSelect(where, a.X, b.X),
            Numerics.ConditionalSelect(where, a.Y, b.Y),
            Numerics.ConditionalSelect(where, a.Z, b.Z));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public VectorLanes Rotate(VectorLanes v)
        {
            VectorLanes t = 2 * VectorLanes.Cross(Vector, v);
            return v + W * t + VectorLanes.Cross(Vector, t);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public VectorLanes RotateInverse(VectorLanes v)
        {
            VectorLanes t = 2 * VectorLanes.Cross(Vector, v);
            return v - W * t + VectorLanes.Cross(Vector, t);
        }
    }
}
#endif
