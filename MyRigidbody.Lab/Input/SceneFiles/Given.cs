using System.Globalization;
using System.Text.Json;

namespace RigidBodyDynamics.Lab;

/// <summary>The fields of a body beside its inertia, the mass properties made from numbers with them, and the notes about that.</summary>
/// <param name="Mass">kg.</param>
/// <param name="Center">The centre of mass, body frame, m.</param>
/// <param name="About">The word for an inertia about the origin; null if it is about the centre of mass.</param>
/// <param name="Depth">The number of compounds that contain it.</param>
internal sealed record Given(double Mass, Vector3d Center, Place? About, int Depth)
{
    // the library's tolerance for rounding, below which no note is needed
    private const double Unsaid = 1e-9;

    /// <summary>The place of the numbers; null where a form is only described.</summary>
    public Place? Shape { get; set; }

    /// <summary>The solid box of a box of vertices.</summary>
    public MassProperties? SolidBox { get; set; }

    public List<string> Notes { get; } = [];

    public MassProperties Principal(Vector3d moments, Quaterniond frame) => About == null
        ? Rounded(moments, frame, Quaterniond.Identity) ?? MassProperties.FromPrincipal(Mass, moments, frame, Vector3d.Zero)
        : Tensor(new SymmetricMatrix3 { XX = moments.X, YY = moments.Y, ZZ = moments.Z }.RotatedBy(Matrix3.Of(frame.Normalized)));

    public MassProperties Tensor(SymmetricMatrix3 inertia)
    {
        SymmetricMatrix3 central = About == null ? inertia : inertia - Mass * SymmetricMatrix3.OfPoint(Center);
        Vector3d moments = PrincipalAxes.Of(central, out Quaterniond frame);
        try
        {
            return Rounded(moments, frame, frame) ?? MassProperties.FromTensor(Mass, central, Center);
        }
        catch (ArgumentException) when (About is Place about)
        {
            throw about.Wrong($"from the origin to the centre of mass {Center} the principal moments become {moments}, which no body has; is the inertia about the centre of mass already?");
        }
    }

    /// <summary>The nearest possible body, where the moments violate the triangle inequality by no more than their digits explain; else null.</summary>
    private MassProperties? Rounded(Vector3d moments, Quaterniond frame, Quaterniond inTyped)
    {
        double largest = Math.Max(moments.X, Math.Max(moments.Y, moments.Z)), excess = largest - (moments.X + moments.Y + moments.Z - largest);
        if (Shape is not Place shape || !(excess > Unsaid * largest))
            return null;

        Vector3d off = TypedDigits.OfMoments(HalfUnits(shape), inTyped);
        if (!(excess <= off.X + off.Y + off.Z) || !(moments.X > 0 && moments.Y > 0 && moments.Z > 0))
            return null;

        Vector3d nearest = MassProperties.NearestPossible(moments, off);
        Notes.Add(string.Create(CultureInfo.InvariantCulture, $"{shape.Path}: principal moment {largest:R} exceeds the sum of the other two by {excess:g2}, as roundings to these digits can do; taken as {nearest}"));
        return MassProperties.FromPrincipal(Mass, nearest, frame, Center);
    }

    private static SymmetricMatrix3 HalfUnits(Place shape)
    {
        string[] names = shape.Value.ValueKind == JsonValueKind.Array ? [] : ["xx", "yy", "zz", "xy", "xz", "yz"];
        double[] half = TypedDigits.HalfUnits(names.Length == 0
            ? [.. shape.List().Select(number => number.Value.GetRawText())]
            : [.. names.Select(name => shape.Value.TryGetProperty(name, out JsonElement number) ? number.GetRawText() : string.Empty)]);
        return names.Length == 0
            ? new SymmetricMatrix3 { XX = half[0], YY = half[1], ZZ = half[2] }
            : new SymmetricMatrix3 { XX = half[0], YY = half[1], ZZ = half[2], XY = half[3], XZ = half[4], YZ = half[5] };
    }
}
