using RigidBodyDynamics.Lab.Meshes;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>The meshes of a robot description, each read once. An unreadable mesh is not an error of the description.</summary>
/// <param name="file">The description.</param>
internal sealed class RobotMeshes(string file)
{
    // the sum over all meshes, however often each is used
    private const long MostTriangles = 20_000_000;
    private const int MostFolders = 6;
    private readonly MeshShelf _read = new();
    private readonly Dictionary<(string, Vector3d), Shape> _shapes = [];
    private long _triangles;

    /// <summary>The solid inside a mesh.</summary>
    /// <exception cref="OmittedException">It cannot be read; the message says why.</exception>
    public Shape Shape(string name, Vector3d scale)
    {
        string path = Found(name);
        if (_shapes.TryGetValue((path, scale), out Shape? known))
            return known;

        MeshFile mesh = Solid(() => _read.Read(path));
        _triangles += mesh.Triangles.Length / 3;
        if (_triangles > MostTriangles)
            throw new OmittedException($"{file}: its meshes have more than {MostTriangles / 1_000_000} million triangles together");

        return _shapes[(path, scale)] = Solid(() => Inertia.Shape.Mesh(mesh.Scaled(scale)));
    }

    // a broken mesh is an error of another file
    private static T Solid<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (InputException broken)
        {
            throw new OmittedException(broken.Message);
        }
    }

    // package://NAME/… is a folder NAME somewhere above the description, or beside one that is
    private string Found(string name)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(file)) ?? ".";
        int scheme = name.IndexOf("://", StringComparison.Ordinal);
        if (scheme < 0)
            return Path.Combine(folder, name);

        string rest = name[(scheme + 3)..];
        if (name.StartsWith("file", StringComparison.Ordinal))
            return rest;

        string inPackage = rest[(rest.IndexOf('/', StringComparison.Ordinal) + 1)..];
        string? above = folder;
        for (int i = 0; i < MostFolders && above != null; i++, above = Path.GetDirectoryName(above))
        {
            foreach (string candidate in new[] { Path.Combine(above, rest), Path.Combine(above, inPackage) })
            {
                if (File.Exists(candidate))
                    return candidate;
            }
        }

        throw new OmittedException($"{name}: there is no such file in the folders above {Path.GetFileName(file)}");
    }
}
