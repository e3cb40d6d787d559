using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>The meshes of a file, each read once, however often it is named.</summary>
internal sealed class MeshShelf
{
    private readonly Dictionary<string, MeshFile> _read = [];
    private long _triangles;

    /// <summary>The files that were read.</summary>
    public IReadOnlyCollection<string> Files => _read.Keys;

    /// <summary>The mesh of a file, read at the first call.</summary>
    /// <exception cref="InputException">It cannot be read, or all meshes together are too large.</exception>
    public MeshFile Read(string path)
    {
        if (_read.TryGetValue(path, out MeshFile? known))
            return known;

        MeshFile mesh = MeshFile.Read(path);
        _triangles += mesh.Triangles.Length / 3;
        return _triangles <= MeshFile.MostTriangles
            ? _read[path] = mesh
            : throw new InputException($"{path}: all meshes together must have at most {MeshFile.MostTriangles} triangles, and they have {_triangles}");
    }
}
