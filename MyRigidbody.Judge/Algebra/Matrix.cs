using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A 3 × 3 matrix, such as an inertia tensor or a rotation.</summary>
    public struct Matrix : IEquatable<Matrix>
    {
        public readonly Vector Row0;
        public readonly Vector Row1;
        public readonly Vector Row2;

        public Matrix(Vector row0, Vector row1, Vector row2)
        {
            Row0 = row0;
            Row1 = row1;
            Row2 = row2;
        }

        public static Matrix Identity => Diagonal(new Vector(1, 1, 1));

        public bool IsFinite => Row0.IsFinite && Row1.IsFinite && Row2.IsFinite;

        public Matrix Transpose => new Matrix(
            new Vector(Row0.X, Row1.X, Row2.X), new Vector(Row0.Y, Row1.Y, Row2.Y), new Vector(Row0.Z, Row1.Z, Row2.Z));

        public double Determinant => Vector.Dot(Row0, Vector.Cross(Row1, Row2));

        /// <summary>The inverse; zero where there is none, as in Unity.</summary>
        public Matrix Inverse
        {
            get
            {
                double d = Determinant;
                Matrix cofactors = new Matrix(Vector.Cross(Row1, Row2), Vector.Cross(Row2, Row0), Vector.Cross(Row0, Row1));
                return Math.Abs(d) < 1e-30 ? default(Matrix) : (1 / d) * cofactors.Transpose;
            }
        }

        /// <summary>The largest absolute value of an element.</summary>
        public double Size => Math.Max(Largest(Row0), Math.Max(Largest(Row1), Largest(Row2)));

        public static Matrix Diagonal(Vector d) => new Matrix(new Vector(d.X, 0, 0), new Vector(0, d.Y, 0), new Vector(0, 0, d.Z));

        /// <summary>Unity's matrix of a quaternion; a rotation only where its length is 1.</summary>
        public static Matrix Rotation(Orientation q) => new Matrix(
            new Vector(1 - 2 * (q.Y * q.Y + q.Z * q.Z), 2 * (q.X * q.Y - q.W * q.Z), 2 * (q.X * q.Z + q.W * q.Y)),
            new Vector(2 * (q.X * q.Y + q.W * q.Z), 1 - 2 * (q.X * q.X + q.Z * q.Z), 2 * (q.Y * q.Z - q.W * q.X)),
            new Vector(2 * (q.X * q.Z - q.W * q.Y), 2 * (q.Y * q.Z + q.W * q.X), 1 - 2 * (q.X * q.X + q.Y * q.Y)));

        /// <summary>Σ (r·r 1 − r rᵀ) over points of equal mass, of 1 kg together.</summary>
        public static Matrix InertiaOf(System.Collections.Generic.IReadOnlyList<Vector> points)
        {
            Matrix sum = default(Matrix);
            foreach (Vector r in points)
            {
                double rr = Vector.Dot(r, r);
                sum += new Matrix(
                    new Vector(rr - r.X * r.X, -r.X * r.Y, -r.X * r.Z),
                    new Vector(-r.Y * r.X, rr - r.Y * r.Y, -r.Y * r.Z),
                    new Vector(-r.Z * r.X, -r.Z * r.Y, rr - r.Z * r.Z));
            }

            return (1.0 / points.Count) * sum;
        }

        public static Matrix operator +(Matrix a, Matrix b) => new Matrix(a.Row0 + b.Row0, a.Row1 + b.Row1, a.Row2 + b.Row2);

        public static Matrix operator -(Matrix a, Matrix b) => new Matrix(a.Row0 - b.Row0, a.Row1 - b.Row1, a.Row2 - b.Row2);

        public static Matrix operator *(double s, Matrix a) => new Matrix(s * a.Row0, s * a.Row1, s * a.Row2);

        public static Vector operator *(Matrix a, Vector v) => new Vector(Vector.Dot(a.Row0, v), Vector.Dot(a.Row1, v), Vector.Dot(a.Row2, v));

        public static Matrix operator *(Matrix a, Matrix b)
        {
            Matrix columns = b.Transpose;
            return new Matrix(columns * a.Row0, columns * a.Row1, columns * a.Row2);
        }

        public bool Equals(Matrix other) => Row0.Equals(other.Row0) && Row1.Equals(other.Row1) && Row2.Equals(other.Row2);

        public override bool Equals(object obj) => obj is Matrix other && Equals(other);

        public override int GetHashCode() => Row0.GetHashCode() ^ (Row1.GetHashCode() * 31) ^ (Row2.GetHashCode() * 997);

        private static double Largest(Vector v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
    }
}
