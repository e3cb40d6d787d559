namespace RigidBodyDynamics.Tests;

/// <summary>A body of points of 0.3 kg each. Its momenta are summed over them, independently of the library's inertia.</summary>
public sealed record PointBody(string Name, Vector3d[] Points)
{
    private const double Each = 0.3;

    /// <summary>A ball, two tops with an axis, and two without: one in principal axes, one turned in its frame and beside its centre of mass.</summary>
    public static PointBody[] All { get; } =
    [
        new("ball", [.. Corners(1, 1, 1)]),
        new("rod-like", [.. Corners(0.4, 0.4, 1)]),
        new("disc-like", [.. Corners(1, 1, 0.4)]),
        new("three moments", [.. Corners(0.5, 1, 1.5)]),
        new("turned and off centre", [new(1, 0, 0.2), new(-0.5, 1, 0), new(0, -0.7, 1.5), new(0.3, 0.3, -1)]),
    ];

    public MassProperties Mass { get; } = PointMasses.Equal(Each * Points.Length, Points);

    /// <summary>Σ m v.</summary>
    public Vector3d Momentum(BodyState state) => Sum(state, (_, v) => v);

    /// <summary>Σ m r × v about the origin of the world.</summary>
    public Vector3d AngularMomentum(BodyState state) => Sum(state, Vector3d.Cross);

    /// <summary>Σ ½ m v².</summary>
    public double KineticEnergy(BodyState state) => 0.5 * Sum(state, (_, v) => new Vector3d(v.LengthSquared, 0, 0)).X;

    public override string ToString() => Name;

    private Vector3d Sum(BodyState state, Func<Vector3d, Vector3d, Vector3d> of)
    {
        Matrix3 turn = Matrix3.Of(state.Orientation.Normalized);
        Vector3d sum = Vector3d.Zero;
        foreach (Vector3d point in Points)
        {
            Vector3d v = state.Velocity + Vector3d.Cross(state.AngularVelocity, turn * (point - Mass.CenterOfMass));
            sum += Each * of(state.Position + turn * point, v);
        }

        return sum;
    }

    private static IEnumerable<Vector3d> Corners(double x, double y, double z)
    {
        for (int i = 0; i < 8; i++)
            yield return new Vector3d((i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? z : -z);
    }
}
