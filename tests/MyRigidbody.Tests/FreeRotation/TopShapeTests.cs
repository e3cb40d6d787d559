using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The constants of an asymmetric top that follow from its moments.</summary>
public sealed class TopShapeTests
{
    [TestCase(1, 2, 2.5)]
    [TestCase(1, 2.5, 2)]
    [TestCase(2, 1, 2.5)]
    [TestCase(2, 2.5, 1)]
    [TestCase(2.5, 1, 2)]
    [TestCase(2.5, 2, 1)]
    public void Middle_moment_comes_second_and_the_order_stays_cyclic(double x, double y, double z)
    {
        Vector3d moments = new TopShape(new Vector3d(x, y, z), Quaterniond.Identity).Axes.Moments;
        Assert.That(moments.Y, Is.EqualTo(2));
        Assert.That(new[] { new Vector3d(x, y, z), new Vector3d(y, z, x), new Vector3d(z, x, y) }, Does.Contain(moments));
    }

    [TestCase(1, 2, 2.5)]
    [TestCase(2, 2.5, 1)]
    [TestCase(1, 2, 3)]
    public void Invariants_are_those_of_eulers_equations(double i1, double i2, double i3)
    {
        // with energy, |L|² and Euler's equations I w' = I w × w by their definitions, in units of the middle moment
        TopShape s = new(new Vector3d(i1, i2, i3), Quaterniond.Identity);
        double j1 = s.Axes.Moments.X / s.Axes.Moments.Y, j3 = s.Axes.Moments.Z / s.Axes.Moments.Y;
        const double W1 = 0.3, W2 = -1.25, W3 = 2;
        double a1 = s.I1 * W1 * W1 + s.G1 * W2 * W2, a3 = s.I3 * W3 * W3 + s.G3 * W2 * W2;
        double q = s.M1 * W1 * W1 - s.M3 * W3 * W3;
        Assert.That(a1 + a3, Is.EqualTo(j1 * W1 * W1 + W2 * W2 + j3 * W3 * W3).Within(1e-14)); // measured at most 8.9e-16
        Assert.That(j1 * a1 + j3 * a3, Is.EqualTo(j1 * j1 * W1 * W1 + W2 * W2 + j3 * j3 * W3 * W3).Within(1e-14)); // measured at most 8.9e-16
        Assert.That(q, Is.EqualTo(s.G3 * a1 - s.G1 * a3).Within(1e-14)); // measured at most 2.2e-16
        Assert.That((s.K1, s.K2, s.K3), Is.EqualTo(((1 - j3) / j1, j3 - j1, (j1 - 1) / j3)).Using<(double, double, double)>((x, y) =>
            Math.Abs(x.Item1 - y.Item1) + Math.Abs(x.Item2 - y.Item2) + Math.Abs(x.Item3 - y.Item3) < 1e-15)); // measured 0
        // c₁² = 1 − α S² and c₃² = 1 − β S², so that this is what c₃² − c₁² has of S²
        Assert.That(s.AlphaOfA3 * a3 - s.BetaOfA1 * a1, Is.EqualTo(s.DeltaOfQ * q).Within(1e-14)); // measured 0
    }
}
