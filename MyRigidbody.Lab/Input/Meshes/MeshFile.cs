using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>The triangles of a file in STL or OBJ.</summary>
/// <remarks>
/// The readers are our own, because no package that restores reads these formats. They read only positions of corners, into memory
/// of a few times the file, and refuse what they do not understand.
/// </remarks>
/// <param name="Path">The file, as typed.</param>
/// <param name="Vertices">Positions, each once; lengths have no unit in these formats.</param>
/// <param name="Triangles">Three vertex numbers a triangle.</param>
/// <param name="Collapsed">The number of triangles with two equal corners: they have no area, and are left out.</param>
internal sealed record MeshFile(string Path, Vector3d[] Vertices, int[] Triangles, int Collapsed)
{
    /// <summary>The largest number of triangles, tested before they are read; 5 million take about 0.7 GB.</summary>
    public const int MostTriangles = 5_000_000;

    /// <summary>True for a name with the extension of a readable format.</summary>
    public static bool HasKnownName(string path) => IsStl(path) || IsObj(path);

    /// <summary>Reads a file; any error in it is an <see cref="InputException"/>.</summary>
    public static MeshFile Read(string path)
    {
        if (!HasKnownName(path))
            throw new InputException($"{path}: must be a mesh in STL or OBJ (.stl, .obj), whose surface is closed");

        // a scene may name it, and a pipe may not end
        if (File.Exists(path) && !RealPath.IsPlainFile(RealPath.Of(path)))
            throw new InputException($"{path}: is a pipe or a device, not a file");

        ArraySegment<byte> bytes = InputFile.Bytes(path);
        MeshBuilder mesh = new(path);
        if (IsStl(path))
            StlReader.Read(bytes, mesh);
        else
            ObjReader.Read(bytes, mesh);

        return mesh.Triangles.Count > 0
            ? new MeshFile(path, [.. mesh.Vertices], [.. mesh.Triangles], mesh.Collapsed)
            : throw new InputException($"{path}: has no triangle");
    }

    /// <summary>The same with every length times a factor; a mirrored mesh keeps its outside outside.</summary>
    /// <param name="factors">One for each axis, none zero.</param>
    public MeshFile Scaled(Vector3d factors)
    {
        if (factors.X == 0 || factors.Y == 0 || factors.Z == 0 || !factors.IsFinite)
            throw Guard.Refused("scale", factors, "must have three finite factors, none of them zero");

        bool isMirrored = (factors.X < 0) ^ (factors.Y < 0) ^ (factors.Z < 0);
        return this with
        {
            Vertices = [.. Vertices.Select(vertex => Vector3d.Scale(vertex, factors))],
            Triangles = isMirrored ? [.. Triangles.Select((corner, i) => (i % 3) switch { 1 => Triangles[i + 1], 2 => Triangles[i - 1], _ => corner })] : Triangles,
        };
    }

    /// <summary>The solid inside, with a mass.</summary>
    public MassProperties Weighing(double mass) => Enclosed(() => Solids.Mesh(mass, Vertices, Triangles));

    /// <summary>The solid inside, of a material.</summary>
    public MassProperties OfDensity(double density) => Enclosed(() => Solids.MeshOfDensity(density, Vertices, Triangles));

    // only the surface can be wrong here, so the error names the file
    private MassProperties Enclosed(Func<MassProperties> solid)
    {
        try
        {
            return solid();
        }
        catch (ArgumentException refused)
        {
            throw new InputException($"{Path}: {refused.Message}");
        }
    }

    private static bool IsStl(string path) => path.EndsWith(".stl", StringComparison.OrdinalIgnoreCase);

    private static bool IsObj(string path) => path.EndsWith(".obj", StringComparison.OrdinalIgnoreCase);
}
