using CsCheck;

namespace RigidBodyDynamics.Tests;

/// <summary>Random vectors and rotations, mixed with those that break a careless formula.</summary>
internal static class Samples
{
    // CsCheck's range prefers round numbers and its unit does not; both are wanted
    private static readonly Gen<double> Component = Gen.OneOf<double>(
        Gen.Double[-10, 10], Gen.Double.Unit.Select(u => 20 * u - 10), Gen.Double.Unit.Select(u => 20 * u - 10));

    /// <summary>Vectors of any direction but never zero; some along an axis, some with a component far smaller than the others.</summary>
    public static Gen<Vector3d> Vectors { get; } = Gen.OneOf<Vector3d>(
        Gen.Select(Component, Component, Component, (x, y, z) => new Vector3d(x, y, z)).Where(v => v.Length > 0.01),
        Gen.OneOf(new Vector3d(1, 0, 0), new Vector3d(0, -1, 0), new Vector3d(0, 0, 3), new Vector3d(1, 1e-9, 0)));

    /// <summary>Vectors of length 1.</summary>
    public static Gen<Vector3d> Axes { get; } = Vectors.Select(v => v / v.Length);

    /// <summary>Angles from −2π to 2π, among them none, tiny ones, half a revolution and almost half a revolution.</summary>
    public static Gen<double> Angles { get; } = Gen.OneOf<double>(
        Gen.Double.Unit.Select(u => 4 * Math.PI * (u - 0.5)),
        Gen.OneOf(0, 1e-8, -1e-8, 1e-160, Math.PI, -Math.PI, Math.PI - 1e-8, Math.PI + 1e-8, Math.PI - 1e-15, 2 * Math.PI));

    /// <summary>Quaternions of length 1; exactly half a revolution, of either sign, is among them.</summary>
    public static Gen<Quaterniond> Turns { get; } = Gen.OneOf<Quaterniond>(
        Gen.Select(Axes, Angles, (n, angle) => new Quaterniond(Math.Cos(0.5 * angle), Math.Sin(0.5 * angle) * n).Normalized),
        Gen.OneOf(
            Quaterniond.Identity,
            new Quaterniond(-1, 0, 0, 0),
            new Quaterniond(0, 1, 0, 0),
            new Quaterniond(0, 0, -1, 0),
            new Quaterniond(0, 0.6, 0, 0.8),
            new Quaterniond(0.5, 0.5, 0.5, 0.5)));

    /// <summary>Quaternions of any length but zero.</summary>
    public static Gen<Quaterniond> Quaternions { get; } =
        Gen.Select(Turns, Gen.Double[-3, 3], (q, digits) => Math.Pow(10, digits) * q);

    /// <summary>The largest difference of two components.</summary>
    public static double Apart(Vector3d a, Vector3d b) =>
        Math.Max(Math.Abs(a.X - b.X), Math.Max(Math.Abs(a.Y - b.Y), Math.Abs(a.Z - b.Z)));

    /// <summary>The largest difference of two components.</summary>
    public static double Apart(Quaterniond a, Quaterniond b) => Math.Max(Math.Abs(a.W - b.W), Apart(a.Vector, b.Vector));
}
