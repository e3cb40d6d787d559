using RigidBodyDynamics.Scripts;

namespace RigidBodyDynamics.Contacts;

/// <summary>Bodies in PhysX, some of them with the exact top that ExactRotation puts there; stepped as Unity steps them.</summary>
internal sealed class World
{
    public const float Dt = 0.02f;

    private readonly PhysX _engine;
    private readonly EngineBody[] _bodies;
    private readonly ExactTop?[] _tops;
    private readonly Vector3d[] _positions;
    private readonly double _gravity;
    // what is set after a step goes to the engine with the next request, before all else
    private readonly List<double[]> _after = [];

    public World(PhysX engine, Setting setting)
    {
        _engine = engine;
        double[][] inertia = engine.Begin(setting);
        _gravity = -setting.Gravity[1];
        _tops = [.. setting.Bodies.Select(body => body.IsExact ? new ExactTop() : null)];
        _positions = [.. setting.Bodies.Select(body => Vector(body.Position))];
        _bodies = [.. setting.Bodies.Select((body, i) => new EngineBody
        {
            Orientation = Quaterniond.Identity,
            AngularVelocity = Vector((float)body.Spin[0], (float)body.Spin[1], (float)body.Spin[2]),
            Velocity = Vector(body.Velocity),
            Mass = body.Mass,
            InertiaTensor = Vector(inertia[i]),
            InertiaTensorRotation = Quaterniond.Identity,
            SleepThreshold = body.SleepThreshold,
            AngularDrag = body.AngularDrag,
        })];
    }

    public EngineBody this[int i] => _bodies[i];

    public Vector3d Position(int i) => _positions[i];

    /// <summary>The top's where there is one that is followed.</summary>
    public Quaterniond Orientation(int i) => _tops[i] is { IsFollowing: true } top ? top.State.Orientation : _bodies[i].Orientation;

    /// <summary>ω: the top's where there is one that is followed.</summary>
    public Vector3d AngularVelocity(int i) => _tops[i] is { IsFollowing: true } top ? top.State.AngularVelocity : _bodies[i].AngularVelocity;

    /// <summary>Energy of the rotation, J.</summary>
    public double Spin(int i) => 0.5 * Vector3d.Dot(AngularVelocity(i), Momentum(i));

    /// <summary>Energy of a body with its weight's, J.</summary>
    public double Energy(int i) => Motion(i) + (_bodies[i].Mass * _gravity * _positions[i].Y);

    /// <summary>Kinetic energy, J.</summary>
    public double Motion(int i) => Spin(i) + (0.5 * _bodies[i].Mass * _bodies[i].Velocity.LengthSquared);

    public Vector3d Momentum(int i) =>
        Conserved.AngularMomentum(new BodyState(Vector3d.Zero, Orientation(i), Vector3d.Zero, AngularVelocity(i)), _bodies[i].MassProperties(out _));

    public void Step(params double[][] torques)
    {
        List<double[]> set = [];
        for (int i = 0; i < _bodies.Length; i++)
            Set(i, _tops[i]?.Before(_bodies[i], Dt), set);

        double[][] seen = _engine.Step(Dt, [.. _after, .. set], torques);
        _after.Clear();
        for (int i = 0; i < _bodies.Length; i++)
        {
            double[] s = seen[i];
            _positions[i] = new Vector3d(s[0], s[1], s[2]);
            _bodies[i].Orientation = new Quaterniond(s[6], s[3], s[4], s[5]);
            _bodies[i].Velocity = new Vector3d(s[7], s[8], s[9]);
            _bodies[i].AngularVelocity = new Vector3d(s[10], s[11], s[12]);
            _bodies[i].IsAsleep = s[13] != 0;
            Set(i, _tops[i]?.After(_bodies[i]), _after);
        }
    }

    private void Set(int i, Vector3d? velocity, List<double[]> set)
    {
        if (velocity is not Vector3d w)
            return;

        _bodies[i].AngularVelocity = w;
        set.Add([i, w.X, w.Y, w.Z]);
    }

    private static Vector3d Vector(params double[] v) => new(v[0], v[1], v[2]);
}
