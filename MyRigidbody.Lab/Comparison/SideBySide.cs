using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>Bodies that move at the same time, each with its turn since the start.</summary>
internal sealed class SideBySide
{
    private readonly Simulation _simulation;
    private readonly BodyState[] _states;
    private readonly Vector3d[] _turned;

    /// <summary>All of them at their starts.</summary>
    public SideBySide(TimeSteps steps, params BodyDescription[] bodies)
    {
        _simulation = new Simulation(steps, [.. bodies.Select((body, i) => body.Copy($"{body.Name}, {i + 1} of {bodies.Length}", body.Mass))]);
        _states = [.. _simulation.Bodies.Select(body => body.State)];
        _turned = new Vector3d[bodies.Length];
    }

    public long StepsDone => _simulation.StepsDone;

    /// <summary>The state of a body now.</summary>
    public BodyState this[int body] => _states[body];

    /// <summary>
    /// The sum of a body's rotations as vectors, rad: unlike the orientation it does not return to zero after a whole revolution.
    /// </summary>
    public Vector3d Turned(int body) => _turned[body];

    /// <summary>The present difference of two bodies.</summary>
    public Moment Between(int a, int b)
    {
        double distance = (_states[a].Position - _states[b].Position).Length;
        return Guard.IsFinite(distance)
            ? new(_simulation.Time, distance, Conserved.AngleBetween(_states[a].Orientation, _states[b].Orientation), (_turned[a] - _turned[b]).Length)
            : throw new FellShortException(FormattableString.Invariant(
                $"body {_simulation.Bodies[a].Name}: is at t = {_simulation.Time:R} s farther from {_simulation.Bodies[b].Name} than a number can say"));
    }

    /// <summary>One step of all.</summary>
    /// <returns>False if there is no step left.</returns>
    public bool Step()
    {
        if (_simulation.StepsDone == _simulation.Scene.Steps.Count)
            return false;

        _simulation.Step();
        for (int i = 0; i < _states.Length; i++)
        {
            BodyState next = _simulation.Bodies[i].State;
            _turned[i] += Turn(_states[i].Orientation, next.Orientation);
            _states[i] = next;
        }

        return true;
    }

    /// <summary>The rotation of one step as a vector: along its axis in the world, with its angle (rad, below π) as length.</summary>
    private static Vector3d Turn(Quaterniond from, Quaterniond to)
    {
        Quaterniond d = to * from.Conjugate;
        double sin = d.Vector.Length;
        return sin == 0 ? Vector3d.Zero : 2 * Math.Atan2(sin, Math.Abs(d.W)) / sin * (d.W < 0 ? -d.Vector : d.Vector);
    }
}
