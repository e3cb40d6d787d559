namespace RigidBodyDynamics.Tests;

/// <summary>3×3 matrices entry by entry, to compare the compact forms with.</summary>
internal static class FullMatrix
{
    public static double[,] Of(SymmetricMatrix3 a) => new[,]
    {
        { a.Diagonal.X, a.OffDiagonal.Z, a.OffDiagonal.Y },
        { a.OffDiagonal.Z, a.Diagonal.Y, a.OffDiagonal.X },
        { a.OffDiagonal.Y, a.OffDiagonal.X, a.Diagonal.Z },
    };

    public static double[,] Of(Matrix3 a) => new[,]
    {
        { a.Row1.X, a.Row1.Y, a.Row1.Z },
        { a.Row2.X, a.Row2.Y, a.Row2.Z },
        { a.Row3.X, a.Row3.Y, a.Row3.Z },
    };

    /// <summary>R of a quaternion of any length, scaled to length 1 in the formula itself.</summary>
    public static double[,] Of(Quaterniond q)
    {
        double s = 2 / q.LengthSquared;
        return new[,]
        {
            { 1 - s * (q.Y * q.Y + q.Z * q.Z), s * (q.X * q.Y - q.W * q.Z), s * (q.X * q.Z + q.W * q.Y) },
            { s * (q.X * q.Y + q.W * q.Z), 1 - s * (q.X * q.X + q.Z * q.Z), s * (q.Y * q.Z - q.W * q.X) },
            { s * (q.X * q.Z - q.W * q.Y), s * (q.Y * q.Z + q.W * q.X), 1 - s * (q.X * q.X + q.Y * q.Y) },
        };
    }

    private static double[,] Diagonal(Vector3d d) => new[,] { { d.X, 0, 0 }, { 0, d.Y, 0 }, { 0, 0, d.Z } };

    /// <summary>F diag(moments) Fᵀ: the tensor with these moments along the axes of a frame.</summary>
    public static double[,] Tensor(Vector3d moments, Quaterniond frame)
    {
        double[,] f = Of(frame);
        return Product(f, Product(Diagonal(moments), Transposed(f)));
    }

    public static double[,] Product(double[,] a, double[,] b)
    {
        double[,] c = new double[3, 3];
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
                c[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j] + a[i, 2] * b[2, j];
        }

        return c;
    }

    public static Vector3d Product(double[,] a, Vector3d v) => new(
        a[0, 0] * v.X + a[0, 1] * v.Y + a[0, 2] * v.Z,
        a[1, 0] * v.X + a[1, 1] * v.Y + a[1, 2] * v.Z,
        a[2, 0] * v.X + a[2, 1] * v.Y + a[2, 2] * v.Z);

    public static double[,] Transposed(double[,] a)
    {
        double[,] t = new double[3, 3];
        for (int i = 0; i < 9; i++)
            t[i / 3, i % 3] = a[i % 3, i / 3];
        return t;
    }

    /// <summary>The largest difference of two entries.</summary>
    public static double Apart(double[,] a, double[,] b)
    {
        double largest = 0;
        for (int i = 0; i < 9; i++)
            largest = Math.Max(largest, Math.Abs(a[i / 3, i % 3] - b[i / 3, i % 3]));
        return largest;
    }

    /// <summary>The largest entry, without its sign.</summary>
    public static double Size(double[,] a) => Apart(a, new double[3, 3]);

    /// <summary>The six numbers of a symmetric matrix.</summary>
    public static SymmetricMatrix3 Symmetric(double[,] a) =>
        new(new Vector3d(a[0, 0], a[1, 1], a[2, 2]), new Vector3d(a[1, 2], a[0, 2], a[0, 1]));
}
