namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>A body as described in a file, possible or not.</summary>
/// <param name="Name">Its name in the file.</param>
/// <param name="Place">Its place in the file: "line 12", "bodies[0]".</param>
internal sealed record DescribedBody(string Name, string Place)
{
    /// <summary>kg; null where the file says nothing of mass and inertia.</summary>
    public double? Mass { get; init; }

    /// <summary>Centre of mass, body frame, m.</summary>
    public Vector3d Center { get; init; }

    /// <summary>Takes the axes of the tensor to those of the body.</summary>
    public Quaterniond Axes { get; init; } = Quaterniond.Identity;

    /// <summary>About the centre of mass, in the axes of the tensor, kg m².</summary>
    public SymmetricMatrix3 Tensor { get; init; }

    /// <summary>Half a unit of the last written digit of each of its numbers; zero where it was computed.</summary>
    public SymmetricMatrix3 HalfDigits { get; init; }

    /// <summary>True where mass and inertia follow from the body's geometry: the file has no numbers to check.</summary>
    public bool IsComputed { get; init; }

    /// <summary>The numbers of a file that lists six without names, in their order.</summary>
    public double[]? Listed { get; init; }

    /// <summary>The geometry in the file; null if there is none, or none that is understood.</summary>
    public Geometry? Geometry { get; init; }

    /// <summary>Parts that the reader did not understand or had to choose, one sentence each.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    /// <summary>Errors found by the reader.</summary>
    public IReadOnlyList<Finding> Faults { get; init; } = [];

    /// <summary>The tensor in the body's axes.</summary>
    public SymmetricMatrix3 InBodyAxes => Axes == Quaterniond.Identity ? Tensor : Tensor.RotatedBy(Matrix3.Of(Axes.Normalized));
}

/// <summary>The certainty of a finding.</summary>
internal enum Severity
{
    /// <summary>Information; there may be no error.</summary>
    Note,

    /// <summary>The numbers are those of a common mistake.</summary>
    Doubtful,

    /// <summary>No body can have these numbers.</summary>
    Wrong,
}

/// <summary>One error in a body.</summary>
/// <param name="Code">A short name that does not change.</param>
/// <param name="Severity">Its certainty.</param>
/// <param name="Text">In words.</param>
internal sealed record Finding(string Code, Severity Severity, string Text);
