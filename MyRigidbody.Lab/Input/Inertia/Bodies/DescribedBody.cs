namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>A body as a file describes it, possible or not.</summary>
/// <param name="Name">What the file calls it.</param>
/// <param name="Place">Where it stands there: "line 12", "bodies[0]".</param>
internal sealed record DescribedBody(string Name, string Place)
{
    /// <summary>kg; null where the file says nothing of mass and inertia.</summary>
    public double? Mass { get; init; }

    /// <summary>Centre of mass, body frame, m.</summary>
    public Vector3d Center { get; init; }

    /// <summary>Takes the axes of the tensor to those of the body.</summary>
    public Quaterniond Axes { get; init; } = Quaterniond.Identity;

    /// <summary>About the centre of mass, in axes of its own, kg m².</summary>
    public SymmetricMatrix3 Tensor { get; init; }

    /// <summary>Half of what the last written digit of each of its numbers stands for; zero where it was computed.</summary>
    public SymmetricMatrix3 HalfDigits { get; init; }

    /// <summary>True where mass and inertia follow from the body's geometry: there is no number of the file's to doubt.</summary>
    public bool IsComputed { get; init; }

    /// <summary>The numbers of a file that lists six without names, in the order in which they stand.</summary>
    public double[]? Listed { get; init; }

    /// <summary>What the file says the body looks like; null if nothing, or nothing that is understood.</summary>
    public Geometry? Geometry { get; init; }

    /// <summary>What the reader did not understand or had to choose, a sentence each.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    /// <summary>What the reader found wrong.</summary>
    public IReadOnlyList<Finding> Faults { get; init; } = [];

    /// <summary>The tensor in the body's axes.</summary>
    public SymmetricMatrix3 InBodyAxes => Axes == Quaterniond.Identity ? Tensor : Tensor.RotatedBy(Matrix3.Of(Axes.Normalized));
}

/// <summary>How sure a finding is.</summary>
internal enum Severity
{
    /// <summary>Worth knowing; nothing may be wrong.</summary>
    Note,

    /// <summary>The numbers are those of a usual mistake.</summary>
    Doubtful,

    /// <summary>No body is like that.</summary>
    Wrong,
}

/// <summary>One thing that is wrong with a body.</summary>
/// <param name="Code">A short name that stays.</param>
/// <param name="Severity">How sure it is.</param>
/// <param name="Text">In words.</param>
internal sealed record Finding(string Code, Severity Severity, string Text);
