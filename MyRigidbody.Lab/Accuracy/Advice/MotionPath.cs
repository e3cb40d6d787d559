namespace RigidBodyDynamics.Lab;

/// <summary>The motion of one body at any time: its states at many times, and an interpolation between them.</summary>
/// <remarks>
/// Hermite interpolation: the polynomial of degree 7 through the positions and velocities of four neighbouring states, and so for
/// the orientation, whose derivative is ½ ω q. Its error is of order eight in the distance of the states. The four states are never
/// taken from both sides of a time at which an effect begins or ends.
/// </remarks>
internal sealed class MotionPath
{
    private const int Nodes = 4;

    private readonly BodyDescription _body;
    private readonly IReadOnlyList<double> _cuts;
    private readonly int[] _firsts;
    private readonly double[] _times;
    private readonly BodyState[] _states;

    /// <summary>A path.</summary>
    /// <param name="body">The body; a locked translation or rotation stays constant.</param>
    /// <param name="cuts">The times between which the motion is smooth, s.</param>
    /// <param name="intervals">The number of intervals of one length between two cuts, four or more.</param>
    /// <param name="steps">The intervals.</param>
    /// <param name="states">The state at the beginning, and at the end of each interval.</param>
    public MotionPath(BodyDescription body, IReadOnlyList<double> cuts, IReadOnlyList<int> intervals, TimeSteps steps, BodyState[] states)
    {
        _body = body;
        _cuts = cuts;
        _states = states;
        _times = new double[states.Length];
        for (int i = 0; i < _times.Length; i++)
            _times[i] = steps.StartOf(i);

        _firsts = new int[cuts.Count];
        for (int i = 1; i < _firsts.Length; i++)
            _firsts[i] = _firsts[i - 1] + intervals[i - 1];
    }

    /// <summary>The times of the states, s.</summary>
    public IReadOnlyList<double> Times => _times;

    public IReadOnlyList<BodyState> States => _states;

    /// <summary>The state at any time up to the last, s.</summary>
    public BodyState At(double time)
    {
        int piece = 0;
        while (piece < _firsts.Length - 2 && time > _cuts[piece + 1])
            piece++;

        int first = _firsts[piece], last = _firsts[piece + 1];
        double interval = (_cuts[piece + 1] - _cuts[piece]) / (last - first);
        int nearest = Math.Clamp(first + (int)Math.Round((time - _cuts[piece]) / interval), first, last);
        int from = Math.Clamp(first + (int)Math.Floor((time - _cuts[piece]) / interval) - 1, first, last - Nodes + 1);
        return Between(from, nearest, interval, time);
    }

    /// <summary>The difference of two states: the larger of the angle (rad) and the distance (m).</summary>
    public static double Apart(in BodyState a, in BodyState b) =>
        Math.Max(Conserved.AngleBetween(a.Orientation, b.Orientation), (a.Position - b.Position).Length);

    /// <summary>Relative to the nearest state, so that nothing is rounded at the states themselves.</summary>
    private BodyState Between(int from, int nearest, double interval, double time)
    {
        Vector3d offset = _body.Mass.CenterOfMass;
        BodyState near = _states[nearest];
        Vector3d place = default, velocity = default;
        Quaterniond turn = default, rate = default;
        double s = (time - _times[nearest]) / interval + (nearest - from);
        for (int i = 0; i < Nodes; i++)
        {
            BodyState node = _states[from + i];
            HermiteBasis basis = HermiteBasis.Of(i, s);
            if (_body.CanMove)
            {
                // a position is that of the origin of the body frame, a velocity that of the centre of mass
                Vector3d moves = interval * (node.Velocity - Vector3d.Cross(node.AngularVelocity, node.Orientation.Rotate(offset)));
                Vector3d apart = node.Position - near.Position;
                place += basis.Value * apart + basis.Slope * moves;
                velocity += basis.ValueRate * apart + basis.SlopeRate * moves;
            }

            if (_body.CanTurn)
            {
                Quaterniond q = Dot(node.Orientation, near.Orientation) < 0 ? -1 * node.Orientation : node.Orientation;
                Quaterniond turns = 0.5 * interval * (new Quaterniond(0, node.AngularVelocity) * q);
                Quaterniond apart = q + -1 * near.Orientation;
                turn += basis.Value * apart + basis.Slope * turns;
                rate += basis.ValueRate * apart + basis.SlopeRate * turns;
            }
        }

        Quaterniond orientation = near.Orientation + turn;
        Vector3d spin = _body.CanTurn ? 2 / interval * (rate * orientation.Conjugate).Vector : Vector3d.Zero;
        Vector3d moved = _body.CanMove ? 1 / interval * velocity + Vector3d.Cross(spin, orientation.Rotate(offset)) : Vector3d.Zero;
        return new BodyState(near.Position + place, orientation, moved, spin);
    }

    private static double Dot(Quaterniond a, Quaterniond b) => a.W * b.W + Vector3d.Dot(a.Vector, b.Vector);
}
