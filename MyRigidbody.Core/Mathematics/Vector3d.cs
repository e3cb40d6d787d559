using System;
using System.Globalization;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>Three numbers in double precision: a position, a velocity, a torque.</summary>
    /// <remarks>Every operation is written in one order, so that all runtimes round it alike.</remarks>
    public struct Vector3d
    {
        /// <summary>Component along the first axis.</summary>
        public double X;

        /// <summary>Component along the second axis.</summary>
        public double Y;

        /// <summary>Component along the third axis.</summary>
        public double Z;

        /// <summary>The vector (x, y, z).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>The vector (0, 0, 0).</summary>
        public static Vector3d Zero => new Vector3d(0, 0, 0);

        /// <summary>True if every component is zero, of either sign.</summary>
        public bool IsZero { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => X == 0 && Y == 0 && Z == 0; }

        /// <summary>True if no component is infinite or NaN.</summary>
        public bool IsFinite => (X - X) + (Y - Y) + (Z - Z) == 0;

        /// <summary>x² + y² + z².</summary>
        public double LengthSquared { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => Dot(this, this); }

        /// <summary>The length. Over- and underflows where its square does.</summary>
        public double Length { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => Math.Sqrt(LengthSquared); }

        /// <summary>The vector of length 1 in the same direction, for any length; zero for zero.</summary>
        public Vector3d Normalized
        {
            get
            {
                Vector3d scaled = IsZero ? this : this / Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));
                return IsZero ? this : scaled / scaled.Length;
            }
        }

        /// <summary>Sum, component by component.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator +(Vector3d a, Vector3d b) => new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        /// <summary>Difference, component by component.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator -(Vector3d a, Vector3d b) => new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        /// <summary>The opposite vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator -(Vector3d a) => new Vector3d(-a.X, -a.Y, -a.Z);

        /// <summary>Every component times s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator *(double s, Vector3d a) => new Vector3d(s * a.X, s * a.Y, s * a.Z);

        /// <summary>Every component times s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator *(Vector3d a, double s) => s * a;

        /// <summary>Every component divided by s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator /(Vector3d a, double s) => new Vector3d(a.X / s, a.Y / s, a.Z / s);

        /// <summary>Scalar product.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static double Dot(Vector3d a, Vector3d b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        /// <summary>Vector product a × b.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d Cross(Vector3d a, Vector3d b) =>
            new Vector3d(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        /// <summary>Product component by component, as a diagonal matrix multiplies.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d Scale(Vector3d a, Vector3d b) => new Vector3d(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

        /// <summary>Adds a multiple of it to a sum, without operators: with them Mono, which does not keep structs in registers, takes twice as long.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal void AddTo(ref Vector3d sum, double factor)
        {
            sum.X += factor * X;
            sum.Y += factor * Y;
            sum.Z += factor * Z;
        }

        /// <summary>True if all components are equal; no tolerance.</summary>
        public static bool operator ==(Vector3d a, Vector3d b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z;

        /// <summary>True if any component differs; no tolerance.</summary>
        public static bool operator !=(Vector3d a, Vector3d b) => !(a == b);

        public override bool Equals(object obj) =>
            obj is Vector3d other && X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

        public override int GetHashCode() => (X.GetHashCode() * 31 + Y.GetHashCode()) * 31 + Z.GetHashCode();

        /// <summary>The components in brackets, shortest digits that read back to the same bits.</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "({0:R}, {1:R}, {2:R})", X, Y, Z);
    }
}
