namespace RigidBodyDynamics.Lab;

/// <summary>
/// Different starts of many bodies: each number uniformly within an interval about that of the first, each orientation rotated
/// about any axis by at most an angle. The same seed gives the same starts on every runtime.
/// </summary>
internal sealed class Spread
{
    private Vector3d _position, _velocity, _angularVelocity;
    private double _orientation;

    /// <summary>Of the position, m, each component in both directions.</summary>
    public Vector3d Position { get => _position; set => _position = Guard.Finite(value, nameof(Position)); }

    /// <summary>Of the velocity, m/s.</summary>
    public Vector3d Velocity { get => _velocity; set => _velocity = Guard.Finite(value, nameof(Velocity)); }

    /// <summary>Of the angular velocity, rad/s.</summary>
    public Vector3d AngularVelocity { get => _angularVelocity; set => _angularVelocity = Guard.Finite(value, nameof(AngularVelocity)); }

    /// <summary>Of the orientation, the largest angle, rad.</summary>
    public double Orientation { get => _orientation; set => _orientation = Guard.NotNegative(value, nameof(Orientation)); }

    /// <summary>Any number; another one gives other starts.</summary>
    public long Seed { get; set; }

    /// <summary>The start of one of the bodies.</summary>
    /// <param name="start">That of the body in the middle.</param>
    /// <param name="index">Its number, from 0.</param>
    public BodyState Of(BodyState start, long index)
    {
        Guard.Finite(start.Position, nameof(start));
        Guard.Finite(start.Velocity, nameof(start));
        Guard.Finite(start.AngularVelocity, nameof(start));
        Guard.Turn(start.Orientation, nameof(start));
        // a random sequence of its own for each body, so that none depends on those before
        ulong state = Mixed(unchecked((ulong)Seed * 0x9E3779B97F4A7C15UL + (ulong)index));
        start.Position += Vector3d.Scale(_position, Next(ref state));
        start.Velocity += Vector3d.Scale(_velocity, Next(ref state));
        start.AngularVelocity += Vector3d.Scale(_angularVelocity, Next(ref state));
        Vector3d axis = Next(ref state);
        double length = axis.Length;
        if (_orientation > 0 && length > 0)
            start.Orientation = Quaterniond.FromAxisAngle(axis, _orientation * Unit(ref state)) * start.Orientation;

        return start;
    }

    private static Vector3d Next(ref ulong state) => new Vector3d(Unit(ref state), Unit(ref state), Unit(ref state));

    /// <summary>From −1 to 1.</summary>
    private static double Unit(ref ulong state)
    {
        state = unchecked(state + 0x9E3779B97F4A7C15UL);
        return (long)(Mixed(state) >> 11) * (2.0 / (1L << 53)) - 1;
    }

    /// <summary>The finaliser of SplitMix64: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.</summary>
    private static ulong Mixed(ulong z)
    {
        z = unchecked((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL);
        z = unchecked((z ^ (z >> 27)) * 0x94D049BB133111EBUL);
        return z ^ (z >> 31);
    }
}
