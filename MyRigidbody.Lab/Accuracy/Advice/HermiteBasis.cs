namespace RigidBodyDynamics.Lab;

/// <summary>The weights of one of four nodes at 0, 1, 2, 3 in Hermite interpolation: of its value and of its slope, and their derivatives.</summary>
/// <remarks>With Lagrange's L of the node at c: (1 − 2 (s − c) L'(c)) L², and (s − c) L².</remarks>
internal readonly record struct HermiteBasis(double Value, double Slope, double ValueRate, double SlopeRate)
{
    // of L: one over the product of the distances to the other nodes, and the sum of one over each of them
    private static readonly double[] Scale = [-1.0 / 6, 0.5, -0.5, 1.0 / 6];
    private static readonly double[] SlopeThere = [-11.0 / 6, -0.5, 0.5, 11.0 / 6];

    /// <summary>For a node, at a place.</summary>
    public static HermiteBasis Of(int node, double s)
    {
        double a = s - Other(node, 0), b = s - Other(node, 1), c = s - Other(node, 2), d = s - node;
        double l = Scale[node] * a * b * c, rate = Scale[node] * (a * b + b * c + c * a);
        double outer = 1 - 2 * d * SlopeThere[node], square = l * l, squareRate = 2 * l * rate;
        return new HermiteBasis(outer * square, d * square, outer * squareRate - 2 * SlopeThere[node] * square, d * squareRate + square);
    }

    private static int Other(int node, int i) => i < node ? i : i + 1;
}
