using System.Globalization;
using System.Text.Json;

namespace RigidBodyDynamics.Tests;

/// <summary>A body recorded with PhysX: all inputs, and its state after every step, every number a float.</summary>
internal sealed class PhysxRecording
{
    private readonly JsonElement _json;

    private PhysxRecording(string name)
    {
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(TestData.Physx(name + ".json")));
        _json = json.RootElement.Clone();
        string[] lines = File.ReadAllLines(TestData.Physx(name + ".csv"));
        Columns = lines[0].Split(',');
        Rows = [.. lines.Skip(1).Select(line => line.Split(',').Select(s => float.Parse(s, CultureInfo.InvariantCulture)).ToArray())];
    }

    public string[] Columns { get; }

    /// <summary>Row 0 is the start, row k the state after k steps.</summary>
    public float[][] Rows { get; }

    public double[] StepLengths => List("dt");

    public PerStep Pushes => new(Triples("force"), Triples("torque"));

    public Coasting Coasting
    {
        get
        {
            Coasting coasting = Coasting.Free;
            if (Flag("useGravity"))
                coasting.Acceleration = Vector("gravity");
            return coasting;
        }
    }

    public static PhysxRecording Read(string name) => new(name);

    public BodyDescription Body() => new(_json.GetProperty("name").GetString()!, MassProperties.FromPrincipal(
        Number("mass"), Vector("inertiaTensor"), Turn("inertiaTensorRotation"), Vector("centerOfMass")))
    {
        Rule = Rules.UnityRigidbody,
        Start = new BodyState(Vector("position"), Turn("rotation"), Vector("linearVelocity"), Vector("angularVelocity")),
        Unity = new UnitySettings
        {
            Drag = Number("linearDamping"),
            AngularDrag = Number("angularDamping"),
            MaxAngularVelocity = Number("maxAngularVelocity"),
            SleepThreshold = Number("sleepThreshold"),
            WakeCounter = Number("wakeCounter"),
            GyroscopicForces = Flag("gyroscopicForces"),
        },
    };

    private double Number(string name) => _json.GetProperty(name).GetSingle();

    private bool Flag(string name) => _json.GetProperty(name).GetBoolean();

    private double[] List(string name) => [.. _json.GetProperty(name).EnumerateArray().Select(n => (double)n.GetSingle())];

    private Vector3d Vector(string name)
    {
        double[] n = List(name);
        return new Vector3d(n[0], n[1], n[2]);
    }

    // PhysX writes (x, y, z, w)
    private Quaterniond Turn(string name)
    {
        double[] n = List(name);
        return new Quaterniond(n[3], n[0], n[1], n[2]);
    }

    private Vector3d[] Triples(string name) => [.. List(name).Chunk(3).Select(n => new Vector3d(n[0], n[1], n[2]))];
}
