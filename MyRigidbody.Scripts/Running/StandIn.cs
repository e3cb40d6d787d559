using System.Reflection;
using System.Runtime.Loader;
using RigidBodyDynamics.Engine;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Compilation;
using RigidBodyDynamics.StudentScripts.Metering;
using UnityEngine;
using EngineKeys = RigidBodyDynamics.Engine.Keys;
using SheetKeys = RigidBodyDynamics.Judging.Keys;

namespace RigidBodyDynamics.StudentScripts.Running;

/// <summary>The stand-in for the engine with one script on one object, as the judge drives it.</summary>
/// <param name="compiled">The script.</param>
/// <param name="afterFrame">Called when a frame has been played.</param>
internal sealed class StandIn(CompiledScript compiled, Action afterFrame) : ILaboratory, IDisposable
{
    private const long MostBytes = 150_000_000, BytesPerLook = 8_000_000;

    private static readonly (SheetKeys Held, KeyCode Code)[] FiveKeys =
    [
        (SheetKeys.LeftArrow, KeyCode.LeftArrow), (SheetKeys.RightArrow, KeyCode.RightArrow), (SheetKeys.UpArrow, KeyCode.UpArrow),
        (SheetKeys.DownArrow, KeyCode.DownArrow), (SheetKeys.R, KeyCode.R),
    ];

    private const string Context = "script";

    static StandIn()
    {
        Structures.Know<Vector3>(v => [v.x, v.y, v.z]);
        Structures.Know<UnityEngine.Quaternion>(q => [q.x, q.y, q.z, q.w]);
        Structures.Know<Matrix4x4>(m => [m.m00, m.m01, m.m02, m.m10, m.m11, m.m12, m.m20, m.m21, m.m22]);
    }

    private readonly long _bytesAtStart = GC.GetTotalMemory(forceFullCollection: true);
    private long _allocated = GC.GetAllocatedBytesForCurrentThread();
    private AssemblyLoadContext? _context;
    private Type? _type;
    private MonoBehaviour? _script;

    /// <summary>The message that is being sent, for the report on a script that fails in it.</summary>
    public string Message { get; private set; } = "Start";

    /// <summary>Length of a fixed step, s.</summary>
    public double FixedDelta { get; init; } = FrameInput.FixedDelta;

    /// <summary>Frames since the present object began.</summary>
    public int FramesDone { get; private set; }

    public Pose Pose
    {
        get
        {
            Vector3 position = _script!.transform.position;
            UnityEngine.Quaternion turn = _script.transform.rotation;
            return new Pose(new Vector(position.x, position.y, position.z), new Orientation(turn.x, turn.y, turn.z, turn.w));
        }

        set
        {
            _script!.transform.position = new Vector3((float)value.Position.X, (float)value.Position.Y, (float)value.Position.Z);
            _script.transform.rotation = new UnityEngine.Quaternion((float)value.Orientation.X, (float)value.Orientation.Y, (float)value.Orientation.Z, (float)value.Orientation.W);
        }
    }

    public Action<SheetKeys> KeyAsked
    {
        set => EngineKeys.Asked = value == null ? null : code =>
        {
            foreach ((SheetKeys held, KeyCode key) in FiveKeys)
            {
                if (key == code)
                    value(held);
            }
        };
    }

    public object Begin(Setting setting)
    {
        World.Begin(isPlaying: true);
        Messages.ExceptionsPass = true;
        Clock.Set(0, FixedDelta, FixedDelta, 0, isInFixedStep: false);
        GameObject box = GameObject.CreatePrimitive(PrimitiveType.Cube);
        box.GetComponent<MeshFilter>().sharedMesh.vertices = [.. setting.Vertices.Select(v => new Vector3((float)v.X, (float)v.Y, (float)v.Z))];
        box.transform.localScale = new Vector3((float)setting.Scale.X, (float)setting.Scale.Y, (float)setting.Scale.Z);
        Type type = Load();
        foreach (RequireComponent required in type.GetCustomAttributes<RequireComponent>())
            box.AddComponent(required.m_Type0);

        FramesDone = 0;
        Message = compiled.ClassName;
        Guarded(() => _script = (MonoBehaviour)box.Attach(type));
        Pose = setting.Pose;
        return _script!;
    }

    public void Start()
    {
        Message = "Start";
        Guarded(() =>
        {
            _script!.Settle();
            StartWhatIsDue();
        });
    }

    public void Frame(FrameInput input)
    {
        foreach ((SheetKeys held, KeyCode key) in FiveKeys)
            EngineKeys.Hold(key, (input.Held & held) != 0);

        Clock.Set(input.Time, FixedDelta, FixedDelta, input.Number, isInFixedStep: true);
        Send("FixedUpdate");
        Clock.Set(input.Time, input.Delta, FixedDelta, input.Number, isInFixedStep: false);
        Send("Update");
        Send("LateUpdate");
        EngineKeys.EndFrame();
        FramesDone++;
        afterFrame();
        LookAtMemory();
        Meter.MustNotBeStopped();
    }

    // memory that is held, not what a collection would free; measuring takes long where the heap is large
    private void LookAtMemory()
    {
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        if (allocated - _allocated < BytesPerLook)
            return;

        _allocated = allocated;
        if (GC.GetTotalMemory(forceFullCollection: false) - _bytesAtStart > MostBytes && GC.GetTotalMemory(forceFullCollection: true) - _bytesAtStart > MostBytes)
            Meter.Stop(Stopped.Memory);
    }

    public static bool IsOfScript(Assembly? assembly) => assembly != null && AssemblyLoadContext.GetLoadContext(assembly)?.Name == Context;

    public void Dispose()
    {
        World.Begin(isPlaying: true);
        _script = null;
        _type = null;
        _context?.Unload();
    }

    private void Send(string message)
    {
        Message = message;
        Guarded(() =>
        {
            StartWhatIsDue();
            foreach (MonoBehaviour script in World.Scripts.ToArray())
            {
                if (script && script.isActiveAndEnabled)
                    Messages.Send(script, message);
            }
        });
    }

    private static void StartWhatIsDue()
    {
        foreach (MonoBehaviour script in World.Scripts.ToArray())
            script.StartIfDue();
    }

    // exceptions of the script get one type, and a stop by the meter comes first
    private static void Guarded(Action call)
    {
        Meter.BeginMessage();
        try
        {
            call();
        }
        catch (Exception thrown)
        {
            Meter.MustNotBeStopped();
            while (thrown is TargetInvocationException or TypeInitializationException && thrown.InnerException is { } inner)
                thrown = inner;

            throw new ScriptException(thrown);
        }

        Meter.MustNotBeStopped();
    }

    // every object of a script with statics finds their initial values
    private Type Load()
    {
        if (_type != null && !compiled.HasStatics)
            return _type;

        _context?.Unload();
        _context = new AssemblyLoadContext(Context, isCollectible: true);
        Assembly assembly = _context.LoadFromStream(new MemoryStream(compiled.Assembly!), new MemoryStream(compiled.DebugSymbols!));
        return _type = assembly.GetTypes().First(type => type.Name == compiled.ClassName && typeof(MonoBehaviour).IsAssignableFrom(type));
    }
}

internal sealed class ScriptException(Exception thrown) : Exception(thrown.Message, thrown);
