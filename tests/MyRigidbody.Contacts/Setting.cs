using System.Text.Json.Serialization;

namespace RigidBodyDynamics.Contacts;

/// <summary>A world as tests/engines/contacts.mjs reads it: boxes, a floor or a room.</summary>
internal sealed record Setting
{
    public double[] Gravity { get; init; } = [0, -9.81, 0];

    public double Friction { get; init; } = 0.6;

    public double Restitution { get; init; }

    /// <summary>Half an edge of the room around the origin, m; null for none.</summary>
    public double? Room { get; init; }

    /// <summary>A floor at height 0.</summary>
    public bool Floor { get; init; }

    /// <summary>Hangs the first body by its centre on an axis along x.</summary>
    public bool Hinge { get; init; }

    public Box[] Bodies { get; init; } = [];
}

/// <summary>A solid box.</summary>
internal sealed record Box(double[] Edges, double[] Position, double[] Velocity, double[] Spin)
{
    public double Mass { get; init; } = 1;

    public double SleepThreshold { get; init; } = 0.005;

    public double AngularDrag { get; init; }

    /// <summary>Whether ExactRotation is on it.</summary>
    [JsonIgnore]
    public bool IsExact { get; init; }
}
