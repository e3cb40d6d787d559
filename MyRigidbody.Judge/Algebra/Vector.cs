using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Three components along the axes of the world, in the unit of whatever they measure.</summary>
    public struct Vector : IEquatable<Vector>
    {
        public readonly double X;
        public readonly double Y;
        public readonly double Z;

        public Vector(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public static Vector Zero => new Vector(0, 0, 0);

        public double Length => Math.Sqrt(Dot(this, this));

        /// <summary>No component is infinite or not a number.</summary>
        public bool IsFinite => X + Y + Z - (X + Y + Z) == 0;

        public static Vector operator +(Vector a, Vector b) => new Vector(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector operator -(Vector a, Vector b) => new Vector(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vector operator -(Vector a) => new Vector(-a.X, -a.Y, -a.Z);

        public static Vector operator *(double s, Vector a) => new Vector(s * a.X, s * a.Y, s * a.Z);

        public static double Dot(Vector a, Vector b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        public static Vector Cross(Vector a, Vector b) =>
            new Vector(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        public bool Equals(Vector other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

        public override bool Equals(object obj) => obj is Vector other && Equals(other);

        public override int GetHashCode() => X.GetHashCode() ^ (Y.GetHashCode() * 31) ^ (Z.GetHashCode() * 997);
    }
}
