namespace RigidBodyDynamics.Tests;

/// <summary>
/// The lab's five steps written out with arrays, as a student might: full matrices, and a linear system solved where
/// the library inverts.
/// </summary>
internal sealed class PlainStep
{
    public double Mass { get; init; } = 1;

    public double[,] Inertia { get; init; } = new double[3, 3];

    public double[] X { get; } = new double[3];

    public double[] V { get; } = new double[3];

    /// <summary>w, x, y, z.</summary>
    public double[] Q { get; } = [1, 0, 0, 0];

    public double[] W { get; } = new double[3];

    public void Advance(double dt, double[] force, double[] torque, double linearFactor, double angularFactor)
    {
        for (int i = 0; i < 3; i++)
            V[i] += dt * force[i] / Mass;

        double[,] r = Rotation();
        double[] acceleration = Solve(Product(r, Product(Inertia, Transposed(r))), torque);
        for (int i = 0; i < 3; i++)
        {
            W[i] += dt * acceleration[i];
            X[i] += dt * V[i];
        }

        // the quaternion product [0, dt/2 ω] q as a 4×4 matrix times q
        double a = dt / 2 * W[0], b = dt / 2 * W[1], c = dt / 2 * W[2];
        double[,] omega = { { 1, -a, -b, -c }, { a, 1, -c, b }, { b, c, 1, -a }, { c, -b, a, 1 } };
        double[] q = [.. Q];
        for (int i = 0; i < 4; i++)
            Q[i] = omega[i, 0] * q[0] + omega[i, 1] * q[1] + omega[i, 2] * q[2] + omega[i, 3] * q[3];
        double length = Math.Sqrt(Q.Sum(component => component * component));
        for (int i = 0; i < 4; i++)
            Q[i] /= length;

        for (int i = 0; i < 3; i++)
        {
            V[i] *= linearFactor;
            W[i] *= angularFactor;
        }
    }

    private double[,] Rotation()
    {
        double w = Q[0], x = Q[1], y = Q[2], z = Q[3];
        return new[,]
        {
            { w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y) },
            { 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x) },
            { 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z },
        };
    }

    private static double[,] Product(double[,] a, double[,] b) => FullMatrix.Product(a, b);

    private static double[,] Transposed(double[,] a) => FullMatrix.Transposed(a);

    /// <summary>Gauss's elimination.</summary>
    private static double[] Solve(double[,] matrix, double[] right)
    {
        double[,] m = (double[,])matrix.Clone();
        double[] b = [.. right];
        for (int k = 0; k < 2; k++)
        {
            for (int i = k + 1; i < 3; i++)
            {
                double factor = m[i, k] / m[k, k];
                for (int j = k; j < 3; j++)
                    m[i, j] -= factor * m[k, j];
                b[i] -= factor * b[k];
            }
        }

        double z = b[2] / m[2, 2];
        double y = (b[1] - m[1, 2] * z) / m[1, 1];
        return [(b[0] - m[0, 1] * y - m[0, 2] * z) / m[0, 0], y, z];
    }
}
