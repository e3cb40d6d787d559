using System;

namespace UnityEngine
{
    /// <summary>Inverse and determinant of a matrix by Gauss and Jordan, the largest element of a column first.</summary>
    internal static class Elimination
    {
        private const int Size = 4;

        // below this part of the largest element a pivot is a rounding
        private const double Rounding = 1e-13;

        public static Matrix4x4 Inverse(Matrix4x4 matrix)
        {
            double[,] left = Doubles(matrix), right = Doubles(Matrix4x4.identity);
            if (Eliminate(left, right) == 0)
                return Matrix4x4.zero;

            Matrix4x4 inverse = default(Matrix4x4);
            for (int row = 0; row < Size; row++)
            {
                for (int column = 0; column < Size; column++)
                    inverse[row, column] = (float)right[row, column];
            }

            return inverse;
        }

        public static double Determinant(Matrix4x4 matrix) => Eliminate(Doubles(matrix), new double[Size, Size]);

        // left becomes the identity, right the inverse; the determinant, at 0 of which it stops
        private static double Eliminate(double[,] left, double[,] right)
        {
            double determinant = 1, least = Rounding * Largest(left);
            for (int column = 0; column < Size; column++)
            {
                int pivot = column;
                for (int row = column + 1; row < Size; row++)
                {
                    if (Math.Abs(left[row, column]) > Math.Abs(left[pivot, column]))
                        pivot = row;
                }

                double scale = left[pivot, column];
                if (Math.Abs(scale) <= least)
                    return 0;

                determinant *= pivot == column ? scale : -scale;
                for (int i = 0; i < Size; i++)
                {
                    (left[pivot, i], left[column, i]) = (left[column, i], left[pivot, i] / scale);
                    (right[pivot, i], right[column, i]) = (right[column, i], right[pivot, i] / scale);
                }

                for (int row = 0; row < Size; row++)
                {
                    double factor = row == column ? 0 : left[row, column];
                    for (int i = 0; i < Size && factor != 0; i++)
                    {
                        left[row, i] -= factor * left[column, i];
                        right[row, i] -= factor * right[column, i];
                    }
                }
            }

            return determinant;
        }

        private static double Largest(double[,] matrix)
        {
            double largest = 0;
            foreach (double element in matrix)
                largest = Math.Max(largest, Math.Abs(element));

            return largest;
        }

        private static double[,] Doubles(Matrix4x4 matrix)
        {
            double[,] doubles = new double[Size, Size];
            for (int row = 0; row < Size; row++)
            {
                for (int column = 0; column < Size; column++)
                    doubles[row, column] = matrix[row, column];
            }

            return doubles;
        }
    }
}
