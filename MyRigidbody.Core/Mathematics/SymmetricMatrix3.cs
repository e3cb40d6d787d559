using System.Globalization;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A symmetric 3×3 matrix: an inertia tensor, kg m², or its inverse. The six numbers are set by name,
    /// <c>new SymmetricMatrix3 { XX = 1, YY = 2, ZZ = 2.5, XY = 0.1 }</c>, because their order in lists varies.
    /// </summary>
    public struct SymmetricMatrix3
    {
        /// <summary>The diagonal (xx, yy, zz).</summary>
        public Vector3d Diagonal;

        /// <summary>The three off-diagonal numbers: yz, xz, xy.</summary>
        internal Vector3d OffDiagonal;

        /// <summary>The matrix with the diagonal (xx, yy, zz) and yz, xz, xy off it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal SymmetricMatrix3(Vector3d diagonal, Vector3d offDiagonal)
        {
            Diagonal = diagonal;
            OffDiagonal = offDiagonal;
        }

        /// <summary>First number of the diagonal.</summary>
        public double XX { get => Diagonal.X; set => Diagonal.X = value; }

        /// <summary>Second number of the diagonal.</summary>
        public double YY { get => Diagonal.Y; set => Diagonal.Y = value; }

        /// <summary>Third number of the diagonal.</summary>
        public double ZZ { get => Diagonal.Z; set => Diagonal.Z = value; }

        /// <summary>In row x, column y, and row y, column x; of an inertia tensor −Σ m x y, as in URDF's ixy.</summary>
        public double XY { get => OffDiagonal.Z; set => OffDiagonal.Z = value; }

        /// <summary>In row x, column z, and row z, column x; of an inertia tensor −Σ m x z.</summary>
        public double XZ { get => OffDiagonal.Y; set => OffDiagonal.Y = value; }

        /// <summary>In row y, column z, and row z, column y; of an inertia tensor −Σ m y z.</summary>
        public double YZ { get => OffDiagonal.X; set => OffDiagonal.X = value; }

        /// <summary>The unit matrix.</summary>
        public static SymmetricMatrix3 Identity => new SymmetricMatrix3(new Vector3d(1, 1, 1), Vector3d.Zero);

        /// <summary>r rᵀ, the product of every component with every other.</summary>
        public static SymmetricMatrix3 Outer(Vector3d r) =>
            new SymmetricMatrix3(Vector3d.Scale(r, r), new Vector3d(r.Y * r.Z, r.X * r.Z, r.X * r.Y));

        /// <summary>r·r 1 − r rᵀ: the inertia about the origin of 1 kg at r, and in Steiner's rule the term per kg for a distance r from the centre of mass.</summary>
        public static SymmetricMatrix3 OfPoint(Vector3d r)
        {
            // r·r − x² as y² + z²: in the difference a long thin body would lose the moment about its axis
            SymmetricMatrix3 outer = Outer(r);
            Vector3d square = outer.Diagonal;
            return new SymmetricMatrix3(
                new Vector3d(square.Y + square.Z, square.X + square.Z, square.X + square.Y), -outer.OffDiagonal);
        }

        /// <summary>Sum.</summary>
        public static SymmetricMatrix3 operator +(SymmetricMatrix3 a, SymmetricMatrix3 b) =>
            new SymmetricMatrix3(a.Diagonal + b.Diagonal, a.OffDiagonal + b.OffDiagonal);

        /// <summary>Difference.</summary>
        public static SymmetricMatrix3 operator -(SymmetricMatrix3 a, SymmetricMatrix3 b) =>
            new SymmetricMatrix3(a.Diagonal - b.Diagonal, a.OffDiagonal - b.OffDiagonal);

        /// <summary>Every component times s.</summary>
        public static SymmetricMatrix3 operator *(double s, SymmetricMatrix3 a) =>
            new SymmetricMatrix3(s * a.Diagonal, s * a.OffDiagonal);

        /// <summary>Matrix times vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator *(SymmetricMatrix3 a, Vector3d v) => new Vector3d(
            a.Diagonal.X * v.X + a.OffDiagonal.Z * v.Y + a.OffDiagonal.Y * v.Z,
            a.OffDiagonal.Z * v.X + a.Diagonal.Y * v.Y + a.OffDiagonal.X * v.Z,
            a.OffDiagonal.Y * v.X + a.OffDiagonal.X * v.Y + a.Diagonal.Z * v.Z);

        /// <summary>R A Rᵀ: the same tensor in the axes that R maps to.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal SymmetricMatrix3 RotatedBy(Matrix3 r)
        {
            Vector3d a1 = this * r.Row1, a2 = this * r.Row2, a3 = this * r.Row3;
            return new SymmetricMatrix3(
                new Vector3d(Vector3d.Dot(r.Row1, a1), Vector3d.Dot(r.Row2, a2), Vector3d.Dot(r.Row3, a3)),
                new Vector3d(Vector3d.Dot(r.Row2, a3), Vector3d.Dot(r.Row1, a3), Vector3d.Dot(r.Row1, a2)));
        }

        /// <summary>A⁻¹ by cofactors. Loses as many digits as the ratio of the largest to the smallest moment has.</summary>
        public SymmetricMatrix3 Inverse
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                double xx = Diagonal.X, yy = Diagonal.Y, zz = Diagonal.Z;
                double yz = OffDiagonal.X, xz = OffDiagonal.Y, xy = OffDiagonal.Z;
                double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
                double s = 1 / (xx * cxx + xy * cxy + xz * cxz);
                return new SymmetricMatrix3(
                    new Vector3d(s * cxx, s * (xx * zz - xz * xz), s * (xx * yy - xy * xy)),
                    new Vector3d(s * (xy * xz - xx * yz), s * cxz, s * cxy));
            }
        }

        /// <summary>The six numbers, by name.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture, "xx {0:R}, yy {1:R}, zz {2:R}, yz {3:R}, xz {4:R}, xy {5:R}", XX, YY, ZZ, YZ, XZ, XY);
    }
}
