namespace RigidBodyDynamics.Lab.Report;

/// <summary>The object that a student's script moves: its poses come from outside, and its velocities are their differences.</summary>
/// <param name="mass">What energy and momentum are computed with.</param>
/// <param name="start">Where it starts, at rest.</param>
internal sealed class ScriptBody(MassProperties mass, BodyState start)
{
    /// <summary>Where it is, and how it came there from where it was.</summary>
    public BodyState State { get; private set; } = start;

    /// <summary>What energy and momentum are computed with.</summary>
    public MassProperties Mass => mass;

    /// <summary>Takes it to its next pose.</summary>
    /// <param name="position">m.</param>
    /// <param name="orientation">Of any length but zero.</param>
    /// <param name="duration">The time since the last, s.</param>
    public void Move(Vector3d position, Quaterniond orientation, double duration)
    {
        Quaterniond next = orientation.Normalized;
        State = new BodyState(position, next, (1 / duration) * (position - State.Position), (1 / duration) * Turned(State.Orientation, next));
    }

    /// <summary>The shortest turn from one to the other as an axis times an angle, world axes.</summary>
    private static Vector3d Turned(Quaterniond from, Quaterniond to)
    {
        Quaterniond turn = to * from.Conjugate;
        Vector3d half = turn.W < 0 ? new Vector3d(-turn.X, -turn.Y, -turn.Z) : new Vector3d(turn.X, turn.Y, turn.Z);
        double sine = half.Length;
        return sine > 0 ? (2 * Math.Atan2(sine, Math.Abs(turn.W)) / sine) * half : Vector3d.Zero;
    }
}
