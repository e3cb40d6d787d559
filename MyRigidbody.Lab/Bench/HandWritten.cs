namespace RigidBodyDynamics.Lab.Bench;

/// <summary>
/// Steps written by hand for one sum of effects, to compare the cost of the generic ones with. Both give the same bits, which a
/// test verifies.
/// </summary>
internal sealed class HandWritten
{
    private readonly MassProperties _mass;
    private readonly Vector3d _gravity, _force;
    private readonly double _dt, _decay;
    private BodyState _body;

    /// <summary>The lab's step for a constant force, gravity, the key R and a factor per step.</summary>
    public HandWritten(BodyState start, MassProperties mass, Vector3d force, Vector3d gravity, double decay, double dt)
    {
        _body = start;
        _mass = mass;
        _force = force;
        _gravity = gravity;
        _decay = decay;
        _dt = dt;
    }

    public BodyState State => _body;

    /// <summary>Continues stepping from the present state, a number of steps at a time.</summary>
    public Func<Action<long>> Go()
    {
        long done = 0;
        return () => count => Step(done, done += count);
    }

    /// <summary>Takes the steps of a range.</summary>
    public void Step(long first, long end)
    {
        for (long n = first; n < end; n++)
        {
            double t = n * _dt;
            Elementary.SinCos(t, out double sin, out _);
            Vector3d force = Vector3d.Zero + _force, torque = Vector3d.Zero + new Vector3d(sin, sin, sin);
            Vector3d v = _body.Velocity + _dt * (force / _mass.Mass + _gravity);
            Matrix3 r = Matrix3.Of(_body.Orientation);
            SymmetricMatrix3 inertia = _mass.Inertia.RotatedBy(r);
            Vector3d w = _body.AngularVelocity + _dt * (inertia.Inverse * torque);
            _body.Position += _dt * v;
            _body.Orientation = (_body.Orientation + new Quaterniond(0, 0.5 * _dt * w) * _body.Orientation).Normalized;
            _body.Velocity = _decay * v;
            _body.AngularVelocity = _decay * w;
        }
    }
}
