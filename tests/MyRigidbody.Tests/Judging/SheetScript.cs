using System.Numerics;
using RigidBodyDynamics.Judging;
using Vector = RigidBodyDynamics.Judging.Vector;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>The sheet's script in plain C#, in which a test can replace each step.</summary>
internal sealed class SheetScript
{
#pragma warning disable IDE1006 // names as the sheet has them
    public float mass = 1;
    public Vector3 force;
    public Vector3 torque;
    public Vector3 v;
    public Vector3 w;
    public float[] I_ref = new float[9];
#pragma warning restore IDE1006

    public const float Step = 0.02f;

    public Vector3 Position;
    public Quaternion Orientation = Quaternion.Identity;

    /// <summary>The five steps in the order in which they are done.</summary>
    public Action<SheetScript>[] Steps { get; init; } = Right;

    public static Action<SheetScript>[] Right => [Velocity, AngularVelocity, Move, Turn, Damp];

    public Vector3 InverseOfReference => new(1 / I_ref[0], 1 / I_ref[4], 1 / I_ref[8]);

    public static void Velocity(SheetScript s) => s.v += s.force / s.mass * Step;

    public static void AngularVelocity(SheetScript s) => s.w += Step * s.Turned(s.InverseOfReference * s.TurnedBack(s.torque));

    public static void Move(SheetScript s) => s.Position += s.v * Step;

    public static void Turn(SheetScript s) => s.Add(new Quaternion(0.5f * Step * s.w, 0) * s.Orientation);

    public static void Damp(SheetScript s)
    {
        s.v *= 0.98f;
        s.w *= 0.98f;
    }

    public Vector3 Turned(Vector3 inBody) => Vector3.Transform(inBody, Orientation);

    public Vector3 TurnedBack(Vector3 inWorld) => Vector3.Transform(inWorld, Quaternion.Conjugate(Orientation));

    public void Add(Quaternion change) => Orientation = Quaternion.Normalize(Orientation + change);
}

/// <summary>Plays a <see cref="SheetScript"/> as an engine would.</summary>
internal sealed class PlainLaboratory(Func<SheetScript> create) : ILaboratory
{
    private SheetScript _script = create();
    private IReadOnlyList<Vector> _vertices = [];
    private Action<Keys>? _asked;

    public Pose Pose
    {
        get => new(Wide(_script.Position), new Orientation(_script.Orientation.X, _script.Orientation.Y, _script.Orientation.Z, _script.Orientation.W));
        set
        {
            _script.Position = Narrow(value.Position);
            Orientation q = value.Orientation;
            _script.Orientation = new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
        }
    }

    public Action<Keys> KeyAsked
    {
        set => _asked = value;
    }

    public object Begin(Setting setting)
    {
        _script = create();
        _vertices = setting.Vertices;
        Pose = setting.Pose;
        return _script;
    }

    public void Start()
    {
        foreach (Vector r in _vertices)
        {
            double part = _script.mass / _vertices.Count;
            _script.I_ref[0] += (float)(part * (r.Y * r.Y + r.Z * r.Z));
            _script.I_ref[4] += (float)(part * (r.X * r.X + r.Z * r.Z));
            _script.I_ref[8] += (float)(part * (r.X * r.X + r.Y * r.Y));
        }
    }

    public void Frame(FrameInput input)
    {
        float sine = (float)Math.Sin(input.Time);
        _script.torque = input.Held.HasFlag(Keys.R) ? new Vector3(sine, sine, sine) : Vector3.Zero;
        _script.force = 5 * new Vector3(
            Held(input, Keys.RightArrow) - Held(input, Keys.LeftArrow), Held(input, Keys.UpArrow) - Held(input, Keys.DownArrow), 0);
        _asked?.Invoke(Keys.DownArrow);
        foreach (Action<SheetScript> step in _script.Steps)
            step(_script);
    }

    private static float Held(FrameInput input, Keys key) => input.Held.HasFlag(key) ? 1 : 0;

    private static Vector Wide(Vector3 v) => new(v.X, v.Y, v.Z);

    private static Vector3 Narrow(Vector v) => new((float)v.X, (float)v.Y, (float)v.Z);
}
