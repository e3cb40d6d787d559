namespace RigidBodyDynamics.Tests;

/// <summary>
/// A body under a constant torque in its axes and damping, to 24 digits: I ω' = I ω × ω + τ − c I ω and q' = q ω/2 as power
/// series in time, term by term, in decimal numbers. It shares nothing with the library.
/// </summary>
internal static class DampedTop
{
    private const int Terms = 40;
    private const decimal Step = 0.125m;

    /// <summary>Orientation and angular velocity (body axes, the principal ones) after a time, a multiple of 1/8 s.</summary>
    public static (Quaterniond Orientation, Vector3d Spin) After(double time, decimal[] moments, decimal[] spin, decimal[] torque, decimal damping)
    {
        decimal[] w = [.. spin], q = [1, 0, 0, 0];
        for (decimal t = 0; t < (decimal)time; t += Step)
            Advance(w, q, moments, torque, damping);

        return (new Quaterniond((double)q[0], (double)q[1], (double)q[2], (double)q[3]), new Vector3d((double)w[0], (double)w[1], (double)w[2]));
    }

    private static void Advance(decimal[] w, decimal[] q, decimal[] moments, decimal[] torque, decimal damping)
    {
        decimal[][] ws = [.. w.Select(First)], qs = [.. q.Select(First)];
        for (int n = 0; n < Terms; n++)
        {
            for (int i = 0; i < 3; i++)
            {
                int j = (i + 1) % 3, k = (i + 2) % 3;
                decimal turning = (moments[j] - moments[k]) * Product(ws[j], ws[k], n) + (n == 0 ? torque[i] : 0);
                ws[i][n + 1] = (turning / moments[i] - damping * ws[i][n]) / (n + 1);
            }

            decimal half = 0.5m / (n + 1);
            qs[0][n + 1] = -half * (Product(qs[1], ws[0], n) + Product(qs[2], ws[1], n) + Product(qs[3], ws[2], n));
            qs[1][n + 1] = half * (Product(qs[0], ws[0], n) + Product(qs[2], ws[2], n) - Product(qs[3], ws[1], n));
            qs[2][n + 1] = half * (Product(qs[0], ws[1], n) + Product(qs[3], ws[0], n) - Product(qs[1], ws[2], n));
            qs[3][n + 1] = half * (Product(qs[0], ws[2], n) + Product(qs[1], ws[1], n) - Product(qs[2], ws[0], n));
        }

        for (int i = 0; i < 3; i++)
            w[i] = Sum(ws[i]);

        for (int i = 0; i < 4; i++)
            q[i] = Sum(qs[i]);
    }

    private static decimal[] First(decimal value)
    {
        decimal[] series = new decimal[Terms + 1];
        series[0] = value;
        return series;
    }

    /// <summary>The n-th coefficient of a product of two series.</summary>
    private static decimal Product(decimal[] a, decimal[] b, int n)
    {
        decimal sum = 0;
        for (int k = 0; k <= n; k++)
            sum += a[k] * b[n - k];

        return sum;
    }

    private static decimal Sum(decimal[] series) => Enumerable.Reverse(series).Aggregate(0m, (sum, term) => term + sum * Step);
}
