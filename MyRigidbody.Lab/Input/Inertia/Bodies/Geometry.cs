using RigidBodyDynamics.Lab.Meshes;

namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>A shape about its own origin, of a material of 1 kg/m³, and its bounding box.</summary>
/// <param name="Filled">Homogeneous; its mass is its volume.</param>
/// <param name="Low">The lowest corner of the box, m.</param>
/// <param name="High">The highest corner.</param>
internal sealed record Shape(MassProperties Filled, Vector3d Low, Vector3d High)
{
    /// <summary>A box by its full edges.</summary>
    public static Shape Box(Vector3d edges) => About(Solids.Box(edges.X * edges.Y * edges.Z, edges), 0.5 * edges);

    /// <summary>A ball.</summary>
    public static Shape Sphere(double radius) => Ellipsoid(new Vector3d(radius, radius, radius));

    /// <summary>An ellipsoid by its half axes: three fifths of the moments of the box around it.</summary>
    public static Shape Ellipsoid(Vector3d half)
    {
        double volume = 4 * Math.PI / 3 * half.X * half.Y * half.Z;
        return About(MassProperties.FromPrincipal(volume, 0.6 * Solids.Box(volume, 2 * half).PrincipalMoments), half);
    }

    /// <summary>A cylinder along z.</summary>
    public static Shape Cylinder(double radius, double height) =>
        About(Solids.Cylinder(Math.PI * radius * radius * height, radius, height, axis: 2), new Vector3d(radius, radius, 0.5 * height));

    /// <summary>A capsule along z; the height is without its caps.</summary>
    public static Shape Capsule(double radius, double height) => About(
        Solids.Capsule(Math.PI * radius * radius * (height + (4 * radius / 3)), radius, height, axis: 2), new Vector3d(radius, radius, (0.5 * height) + radius));

    /// <summary>The solid inside a closed surface.</summary>
    public static Shape Mesh(MeshFile mesh)
    {
        Vector3d low = mesh.Vertices[0], high = low;
        foreach (Vector3d v in mesh.Vertices)
        {
            low = new Vector3d(Math.Min(low.X, v.X), Math.Min(low.Y, v.Y), Math.Min(low.Z, v.Z));
            high = new Vector3d(Math.Max(high.X, v.X), Math.Max(high.Y, v.Y), Math.Max(high.Z, v.Z));
        }

        return new Shape(mesh.OfDensity(1), low, high);
    }

    private static Shape About(MassProperties filled, Vector3d half) => new(filled, -half, half);
}

/// <summary>The geometry of a body in a file: shapes in the body's frame. Overlaps count twice.</summary>
internal sealed class Geometry
{
    private readonly Compound _parts = new();

    /// <summary>The lowest corner of the common bounding box, m.</summary>
    public Vector3d Low { get; private set; } = new(double.MaxValue, double.MaxValue, double.MaxValue);

    /// <summary>The highest corner.</summary>
    public Vector3d High { get; private set; } = new(double.MinValue, double.MinValue, double.MinValue);

    /// <summary>The number of shapes.</summary>
    public int Count { get; private set; }

    /// <summary>The diagonal of the box.</summary>
    public double Size => (High - Low).Length;

    /// <summary>Adds a shape.</summary>
    public void Add(Shape shape, Vector3d position, Quaterniond orientation, double density = 1)
    {
        MassProperties filled = shape.Filled;
        _parts.With(density == 1 ? filled : Weighing(filled, density * filled.Mass), position, orientation);
        Quaterniond turn = orientation.Normalized;
        for (int corner = 0; corner < 8; corner++)
        {
            Vector3d at = position + turn.Rotate(new Vector3d(
                (corner & 1) == 0 ? shape.Low.X : shape.High.X, (corner & 2) == 0 ? shape.Low.Y : shape.High.Y, (corner & 4) == 0 ? shape.Low.Z : shape.High.Z));
            Low = new Vector3d(Math.Min(Low.X, at.X), Math.Min(Low.Y, at.Y), Math.Min(Low.Z, at.Z));
            High = new Vector3d(Math.Max(High.X, at.X), Math.Max(High.Y, at.Y), Math.Max(High.Z, at.Z));
        }

        Count++;
    }

    /// <summary>All shapes as one body, with the densities with which they were added.</summary>
    public MassProperties Whole() => _parts.ToMassProperties();

    /// <summary>All shapes with one density that gives a mass; null where a number overflows.</summary>
    public MassProperties? Weighing(double mass)
    {
        try
        {
            return Weighing(Whole(), mass);
        }
        catch (ArgumentException)
        {
            return null;
        }
    }

    private static MassProperties Weighing(MassProperties body, double mass) =>
        MassProperties.FromTensor(mass, mass / body.Mass * body.Inertia, body.CenterOfMass);
}
