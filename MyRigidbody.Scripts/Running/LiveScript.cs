using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Compilation;

namespace RigidBodyDynamics.StudentScripts.Running;

/// <summary>A script on its object, played frame by frame with keys held.</summary>
internal sealed class LiveScript : IDisposable
{
    /// <summary>The count of numbers of a pose: x y z, then the quaternion, its real part first.</summary>
    public const int PoseNumbers = 7;

    private readonly CompiledScript _compiled;
    private readonly StandIn _laboratory;
    private readonly double _delta;
    private long _frames;

    /// <param name="compiled">The script.</param>
    /// <param name="setting">Its object.</param>
    /// <param name="delta">Length of every frame, s.</param>
    public LiveScript(CompiledScript compiled, Setting setting, double delta)
    {
        _compiled = compiled;
        _delta = delta;
        _laboratory = new StandIn(compiled, () => { }) { FixedDelta = delta };
        Stopped = Execution.Try(compiled, _laboratory, () =>
        {
            _laboratory.Begin(setting);
            _laboratory.Start();
        });
    }

    /// <summary>Why it has stopped; null while it plays.</summary>
    public Finding? Stopped { get; private set; }

    /// <summary>Plays frames, and returns the pose after each; fewer where it stops.</summary>
    public double[] Step(Keys held, int count)
    {
        double[] poses = new double[PoseNumbers * count];
        int done = 0;
        Stopped ??= Execution.Try(_compiled, _laboratory, () =>
        {
            for (; done < count; done++)
            {
                _frames++;
                _laboratory.Frame(new FrameInput((int)_frames, _frames * _delta, _delta, held));
                Write(_laboratory.Pose, poses.AsSpan(PoseNumbers * done));
            }
        });
        return done == count ? poses : poses[..(PoseNumbers * done)];
    }

    public void Dispose() => _laboratory.Dispose();

    private static void Write(Pose pose, Span<double> to)
    {
        (to[0], to[1], to[2]) = (pose.Position.X, pose.Position.Y, pose.Position.Z);
        (to[3], to[4], to[5], to[6]) = (pose.Orientation.W, pose.Orientation.X, pose.Orientation.Y, pose.Orientation.Z);
    }
}
