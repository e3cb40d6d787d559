namespace RigidBodyDynamics.Lab.Report;

/// <summary>The object that a student's script moves: its poses are given, and its velocities are their differences.</summary>
/// <param name="mass">For energy and momentum.</param>
/// <param name="start">The start, at rest.</param>
internal sealed class ScriptBody(MassProperties mass, BodyState start)
{
    /// <summary>The present pose, with the velocities of the last move.</summary>
    public BodyState State { get; private set; } = start;

    /// <summary>For energy and momentum.</summary>
    public MassProperties Mass => mass;

    /// <summary>Moves it to its next pose.</summary>
    /// <param name="position">m.</param>
    /// <param name="orientation">Of any length but zero.</param>
    /// <param name="duration">The time since the last, s.</param>
    public void Move(Vector3d position, Quaterniond orientation, double duration)
    {
        Quaterniond next = orientation.Normalized;
        State = new BodyState(position, next, (1 / duration) * (position - State.Position), (1 / duration) * Turned(State.Orientation, next));
    }

    /// <summary>The shortest rotation from one to the other as an axis times an angle, world axes.</summary>
    private static Vector3d Turned(Quaterniond from, Quaterniond to)
    {
        Quaterniond turn = to * from.Conjugate;
        Vector3d half = turn.W < 0 ? new Vector3d(-turn.X, -turn.Y, -turn.Z) : new Vector3d(turn.X, turn.Y, turn.Z);
        double sine = half.Length;
        return sine > 0 ? (2 * Math.Atan2(sine, Math.Abs(turn.W)) / sine) * half : Vector3d.Zero;
    }
}
