using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A quaternion from the body's axes to the world's; Unity's order of components, w last. Its length is not changed.</summary>
    public struct Orientation : IEquatable<Orientation>
    {
        public readonly double X;
        public readonly double Y;
        public readonly double Z;
        public readonly double W;

        public Orientation(double x, double y, double z, double w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public Orientation(Vector vector, double scalar) : this(vector.X, vector.Y, vector.Z, scalar) { }

        public static Orientation Identity => new Orientation(0, 0, 0, 1);

        public Vector Imaginary => new Vector(X, Y, Z);

        public double Length => Math.Sqrt(X * X + Y * Y + Z * Z + W * W);

        public bool IsFinite => X + Y + Z + W - (X + Y + Z + W) == 0;

        public Orientation Conjugate => new Orientation(-X, -Y, -Z, W);

        public Orientation Normalized
        {
            get
            {
                double length = Length;
                return length > 0 ? (1 / length) * this : this;
            }
        }

        public static Orientation operator *(double s, Orientation q) => new Orientation(s * q.X, s * q.Y, s * q.Z, s * q.W);

        public static Orientation operator +(Orientation p, Orientation q) => new Orientation(p.X + q.X, p.Y + q.Y, p.Z + q.Z, p.W + q.W);

        public static Orientation operator *(Orientation p, Orientation q) => new Orientation(
            p.W * q.Imaginary + q.W * p.Imaginary + Vector.Cross(p.Imaginary, q.Imaginary),
            p.W * q.W - Vector.Dot(p.Imaginary, q.Imaginary));

        /// <summary>A rotation by the length of the vector, in radians, about its direction.</summary>
        public static Orientation Turn(Vector rotation)
        {
            double angle = rotation.Length;
            return angle < 1e-12 ? new Orientation(0.5 * rotation, 1) : new Orientation((Math.Sin(angle / 2) / angle) * rotation, Math.Cos(angle / 2));
        }

        /// <summary>The angle between two orientations of any length, in radians.</summary>
        public static double Angle(Orientation p, Orientation q)
        {
            Orientation d = q * p.Conjugate;
            return 2 * Math.Atan2(d.Imaginary.Length, Math.Abs(d.W));
        }

        public bool Equals(Orientation other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z) && W.Equals(other.W);

        public override bool Equals(object obj) => obj is Orientation other && Equals(other);

        public override int GetHashCode() => Imaginary.GetHashCode() ^ (W.GetHashCode() * 7919);
    }
}
