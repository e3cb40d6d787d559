namespace RigidBodyDynamics
{
    /// <summary>A vector in twice the digits (<see cref="DoubleDouble"/>).</summary>
    internal readonly struct Vector3dd
    {
        public readonly DoubleDouble X;
        public readonly DoubleDouble Y;
        public readonly DoubleDouble Z;

        public Vector3dd(DoubleDouble x, DoubleDouble y, DoubleDouble z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>A vector and its rounding error.</summary>
        public Vector3dd(Vector3d v, Vector3d lost)
            : this(new DoubleDouble(v.X, lost.X), new DoubleDouble(v.Y, lost.Y), new DoubleDouble(v.Z, lost.Z)) { }

        /// <summary>The nearest vector in double.</summary>
        public Vector3d Rounded => new Vector3d(X.High, Y.High, Z.High);

        /// <summary>The rounding error of <see cref="Rounded"/>.</summary>
        public Vector3d Lost => new Vector3d(X.Low, Y.Low, Z.Low);

        public static implicit operator Vector3dd(Vector3d v) => new Vector3dd(v.X, v.Y, v.Z);

        public static Vector3dd operator +(Vector3dd a, Vector3dd b) => new Vector3dd(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector3dd operator *(DoubleDouble s, Vector3dd a) => new Vector3dd(s * a.X, s * a.Y, s * a.Z);

        public static Vector3dd Scale(Vector3dd a, Vector3dd b) => new Vector3dd(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

        public static DoubleDouble Dot(Vector3dd a, Vector3dd b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        public static Vector3dd Cross(Vector3dd a, Vector3dd b) =>
            new Vector3dd(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
    }
}
