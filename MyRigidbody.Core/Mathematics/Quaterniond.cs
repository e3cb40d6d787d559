using System;
using System.Globalization;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A quaternion, scalar part first. With length 1 it is a rotation and takes vectors of the body to the world:
    /// v_world = q v_body q*. q and −q are the same rotation.
    /// </summary>
    public struct Quaterniond
    {
        /// <summary>Scalar part, cos of half the angle.</summary>
        public double W;

        /// <summary>First component of the vector part, sin of half the angle times the axis.</summary>
        public double X;

        /// <summary>Second component of the vector part.</summary>
        public double Y;

        /// <summary>Third component of the vector part.</summary>
        public double Z;

        /// <summary>The quaternion w + x i + y j + z k.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Quaterniond(double w, double x, double y, double z)
        {
            W = w;
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>The quaternion with a scalar part and a vector part.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Quaterniond(double w, Vector3d v)
        {
            W = w;
            X = v.X;
            Y = v.Y;
            Z = v.Z;
        }

        /// <summary>No rotation.</summary>
        public static Quaterniond Identity => new Quaterniond(1, 0, 0, 0);

        /// <summary>The rotation by an angle (rad) about an axis of any length but zero.</summary>
        public static Quaterniond FromAxisAngle(Vector3d axis, double angle)
        {
            double length = axis.Length;
            Guard.Positive(length, nameof(axis) + " length");
            Elementary.SinCos(0.5 * angle, out double sin, out double cos);
            return new Quaterniond(cos, sin / length * axis);
        }

        /// <summary>The vector part (x, y, z).</summary>
        public Vector3d Vector { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => new Vector3d(X, Y, Z); }

        /// <summary>True if no component is infinite or NaN.</summary>
        public bool IsFinite => (W - W) + (X - X) + (Y - Y) + (Z - Z) == 0;

        /// <summary>w² + x² + y² + z².</summary>
        public double LengthSquared { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => W * W + X * X + Y * Y + Z * Z; }

        /// <summary>The length.</summary>
        public double Length { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => Math.Sqrt(LengthSquared); }

        /// <summary>q*: the inverse rotation, if the length is 1.</summary>
        public Quaterniond Conjugate { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => new Quaterniond(W, -X, -Y, -Z); }

        /// <summary>The quaternion of length 1 in the same direction.</summary>
        public Quaterniond Normalized
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                double s = 1 / Math.Sqrt(LengthSquared);
                return new Quaterniond(s * W, s * X, s * Y, s * Z);
            }
        }

        /// <summary>Scalar product: of two rotations the cosine of half the angle between them, below zero if −b is nearer to a than b.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static double Dot(Quaterniond a, Quaterniond b) => a.W * b.W + a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        /// <summary>
        /// Interpolates two rotations at a constant rate (K. Shoemake, SIGGRAPH 1985) along the shorter arc: a at part = 0, b or −b at
        /// part = 1, and on the same great circle beyond. Lengths must be 1. The same bits on every runtime.
        /// </summary>
        public static Quaterniond Slerp(Quaterniond a, Quaterniond b, double part)
        {
            b = Dot(a, b) < 0 ? -1 * b : b;
            // of half the angle between the rotations; in this form the sine of a small one keeps its digits
            double sin = 0.5 * (b + -1 * a).Length * (a + b).Length, cos = Dot(a, b);
            if (sin == 0)
                return a;

            // an estimate with an error of at most 0.08, corrected by sines three times; each correction leaves δ³/6 of an error δ
            double angle = 1.5707963267948966 * sin / (sin + cos);
            for (int i = 0; i < 3; i++)
            {
                Elementary.SinCos(angle, out double s, out double c);
                angle += sin * c - cos * s;
            }

            return (Elementary.Sin((1 - part) * angle) / sin * a + Elementary.Sin(part * angle) / sin * b).Normalized;
        }

        /// <summary>Interpolates two rotations along the chord, on the shorter side: cheaper than <see cref="Slerp"/>, faster in the middle than at the ends.</summary>
        public static Quaterniond Nlerp(Quaterniond a, Quaterniond b, double part) =>
            ((1 - part) * a + (Dot(a, b) < 0 ? -part : part) * b).Normalized;

        /// <summary>Sum, component by component.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Quaterniond operator +(Quaterniond a, Quaterniond b) =>
            new Quaterniond(a.W + b.W, a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        /// <summary>Hamilton's product: the rotation b, then the rotation a.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Quaterniond operator *(Quaterniond a, Quaterniond b) => new Quaterniond(
            a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z,
            a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
            a.W * b.Y + a.Y * b.W + a.Z * b.X - a.X * b.Z,
            a.W * b.Z + a.Z * b.W + a.X * b.Y - a.Y * b.X);

        /// <summary>Every component times s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Quaterniond operator *(double s, Quaterniond a) => new Quaterniond(s * a.W, s * a.X, s * a.Y, s * a.Z);

        /// <summary>Takes a vector of the body to the world. The length of q must be 1.</summary>
        /// <remarks>v + 2w (u × v) + 2u × (u × v), with u the vector part: 15 products and no square; without structs, because of Mono.</remarks>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3d Rotate(Vector3d v)
        {
            double x = 2 * (Y * v.Z - Z * v.Y), y = 2 * (Z * v.X - X * v.Z), z = 2 * (X * v.Y - Y * v.X);
            return new Vector3d(v.X + W * x + (Y * z - Z * y), v.Y + W * y + (Z * x - X * z), v.Z + W * z + (X * y - Y * x));
        }

        /// <summary>Takes a vector of the world to the body. The length of q must be 1.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3d RotateInverse(Vector3d v)
        {
            double x = 2 * (Y * v.Z - Z * v.Y), y = 2 * (Z * v.X - X * v.Z), z = 2 * (X * v.Y - Y * v.X);
            return new Vector3d(v.X - W * x + (Y * z - Z * y), v.Y - W * y + (Z * x - X * z), v.Z - W * z + (X * y - Y * x));
        }

        /// <summary>True if all components are equal; no tolerance, and q differs from −q.</summary>
        public static bool operator ==(Quaterniond a, Quaterniond b) => a.W == b.W && a.X == b.X && a.Y == b.Y && a.Z == b.Z;

        /// <summary>True if any component differs; no tolerance.</summary>
        public static bool operator !=(Quaterniond a, Quaterniond b) => !(a == b);

        public override bool Equals(object obj) =>
            obj is Quaterniond other && W.Equals(other.W) && Vector.Equals(other.Vector);

        public override int GetHashCode() => W.GetHashCode() * 31 + Vector.GetHashCode();

        /// <summary>The components [w, x, y, z], shortest digits that read back to the same bits.</summary>
        public override string ToString() =>
            string.Format(CultureInfo.InvariantCulture, "[{0:R}, {1:R}, {2:R}, {3:R}]", W, X, Y, Z);
    }
}
