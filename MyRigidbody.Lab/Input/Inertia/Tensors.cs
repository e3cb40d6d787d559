using System.Globalization;

namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>Properties that distinguish the tensor of a body from any six numbers.</summary>
internal static class Tensors
{
    // as in the library: for roundings of sums over points
    private const double Tolerance = 1e-9;

    /// <summary>The three moments, the smallest first.</summary>
    public static double[] Moments(SymmetricMatrix3 tensor)
    {
        Vector3d moments = PrincipalAxes.Of(tensor, out _);
        double[] sorted = [moments.X, moments.Y, moments.Z];
        Array.Sort(sorted);
        return sorted;
    }

    /// <summary>True for the tensor of a possible body: moments above zero, none larger than the sum of the others.</summary>
    public static bool IsPossible(SymmetricMatrix3 tensor)
    {
        double[] moments = Moments(tensor);
        return moments[0] > 0 && Excess(moments) <= Tolerance * moments[2];
    }

    /// <summary>The largest moment minus the sum of the others, kg m².</summary>
    public static double Excess(double[] moments) => moments[2] - moments[1] - moments[0];

    /// <summary>
    /// The nearest tensor of a possible body: same axes, moments changed least (in the sum of squares) until the largest is the sum
    /// of the others; those of a rod where even then one is below zero.
    /// </summary>
    public static SymmetricMatrix3 Nearest(SymmetricMatrix3 tensor)
    {
        Vector3d moments = PrincipalAxes.Of(tensor, out Quaterniond frame);
        double[] m = [moments.X, moments.Y, moments.Z];
        int[] order = [0, 1, 2];
        Array.Sort([.. m], order);
        double shift = Math.Max(0, Excess([m[order[0]], m[order[1]], m[order[2]]]) / 3);
        m[order[0]] += shift;
        m[order[1]] += shift;
        m[order[2]] = shift > 0 ? m[order[0]] + m[order[1]] : m[order[2]];
        if (m[order[0]] <= 0)
        {
            double across = Math.Max(0, 0.5 * (moments.X + moments.Y + moments.Z));
            m[order[0]] = 1e-6 * across;
            m[order[1]] = m[order[2]] = across;
        }

        return new SymmetricMatrix3 { XX = m[0], YY = m[1], ZZ = m[2] }.RotatedBy(Matrix3.Of(frame));
    }

    /// <summary>The tensor with the signs of all products reversed.</summary>
    public static SymmetricMatrix3 Turned(SymmetricMatrix3 t) => new() { XX = t.XX, YY = t.YY, ZZ = t.ZZ, XY = -t.XY, XZ = -t.XZ, YZ = -t.YZ };

    /// <summary>Half the trace: the sum of m r² about the centre.</summary>
    public static double Spread(SymmetricMatrix3 t) => 0.5 * (t.XX + t.YY + t.ZZ);

    /// <summary>The difference of two tensors, as a part of the second.</summary>
    public static double Apart(SymmetricMatrix3 a, SymmetricMatrix3 b) => Size(a - b) / Size(b);

    /// <summary>True if all products are zero.</summary>
    public static bool IsDiagonal(SymmetricMatrix3 t) => t.XY == 0 && t.XZ == 0 && t.YZ == 0;

    /// <summary>The six numbers by their names in URDF; rounding errors are written as zero.</summary>
    public static string Text(SymmetricMatrix3 t, int digits = 12)
    {
        string Shown(string name, double number) =>
            $"{name} {(Math.Abs(number) < 1e-13 * Spread(t) ? 0 : number).ToString($"G{digits}", CultureInfo.InvariantCulture)}";
        string products = string.Join(", ", Shown("ixy", t.XY), Shown("ixz", t.XZ), Shown("iyz", t.YZ));
        return string.Join(", ", Shown("ixx", t.XX), Shown("iyy", t.YY), Shown("izz", t.ZZ)) + (products == "ixy 0, ixz 0, iyz 0" ? string.Empty : ", " + products);
    }

    /// <summary>A number with a few digits.</summary>
    public static string Short(double number) => number.ToString("G4", CultureInfo.InvariantCulture);

    private static double Size(SymmetricMatrix3 t) =>
        Math.Sqrt((t.XX * t.XX) + (t.YY * t.YY) + (t.ZZ * t.ZZ) + (2 * ((t.XY * t.XY) + (t.XZ * t.XZ) + (t.YZ * t.YZ))));
}
