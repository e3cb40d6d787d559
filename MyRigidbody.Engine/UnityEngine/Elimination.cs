using System;

namespace UnityEngine
{
    /// <summary>Inverse and determinant of a matrix by Gauss–Jordan elimination with partial pivoting.</summary>
    internal static class Elimination
    {
        private const int Size = 4;

        // below this part of the largest element a pivot is a rounding
        private const double Rounding = 1e-13;

        public static Matrix4x4 Inverse(Matrix4x4 matrix)
        {
            double[] left = Rows(matrix), right = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
            return Eliminate(left, right) == 0 ? Matrix4x4.zero : new Matrix4x4(Column(right, 0), Column(right, 1), Column(right, 2), Column(right, 3));
        }

        public static double Determinant(Matrix4x4 matrix) => Eliminate(Rows(matrix), new double[Size * Size]);

        // left becomes the identity, right the inverse; returns the determinant, and stops where it is 0
        private static double Eliminate(double[] left, double[] right)
        {
            double determinant = 1, least = Rounding * Largest(left);
            for (int column = 0; column < Size; column++)
            {
                int pivot = column;
                for (int row = column + 1; row < Size; row++)
                {
                    if (Math.Abs(left[row * Size + column]) > Math.Abs(left[pivot * Size + column]))
                        pivot = row;
                }

                double scale = left[pivot * Size + column];
                if (Math.Abs(scale) <= least)
                    return 0;

                determinant *= pivot == column ? scale : -scale;
                int to = column * Size;
                for (int i = 0, from = pivot * Size; i < Size; i++)
                {
                    (left[from + i], left[to + i]) = (left[to + i], left[from + i] / scale);
                    (right[from + i], right[to + i]) = (right[to + i], right[from + i] / scale);
                }

                for (int row = 0; row < Size; row++)
                {
                    int at = row * Size;
                    double factor = row == column ? 0 : left[at + column];
                    for (int i = 0; i < Size && factor != 0; i++)
                    {
                        left[at + i] -= factor * left[to + i];
                        right[at + i] -= factor * right[to + i];
                    }
                }
            }

            return determinant;
        }

        private static Vector4 Column(double[] rows, int at) => new Vector4((float)rows[at], (float)rows[Size + at], (float)rows[2 * Size + at], (float)rows[3 * Size + at]);

        private static double Largest(double[] elements)
        {
            double largest = 0;
            foreach (double element in elements)
                largest = Math.Max(largest, Math.Abs(element));

            return largest;
        }

        private static double[] Rows(Matrix4x4 m) => new double[]
        {
            m.m00, m.m01, m.m02, m.m03, m.m10, m.m11, m.m12, m.m13, m.m20, m.m21, m.m22, m.m23, m.m30, m.m31, m.m32, m.m33,
        };
    }
}
