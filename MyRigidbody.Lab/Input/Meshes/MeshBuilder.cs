using System.Diagnostics.CodeAnalysis;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>
/// Builds a mesh. Corners with the same three numbers, to the last bit, become one vertex: files repeat a corner for every
/// triangle with the same digits.
/// </summary>
internal sealed class MeshBuilder(string path)
{
    private readonly Dictionary<Vector3d, int> _known = new(new ByBits());

    /// <summary>Each position once.</summary>
    public List<Vector3d> Vertices { get; } = [];

    /// <summary>Three vertex numbers a triangle.</summary>
    public List<int> Triangles { get; } = [];

    /// <summary>The number of triangles with two equal corners.</summary>
    public int Collapsed { get; private set; }

    public int Vertex(Vector3d position, string place)
    {
        if (!position.IsFinite)
            throw Wrong(place, "a corner must have three finite numbers, found " + position);

        // turns minus zero into zero
        position += Vector3d.Zero;
        if (_known.TryGetValue(position, out int number))
            return number;

        _known.Add(position, Vertices.Count);
        Vertices.Add(position);
        return Vertices.Count - 1;
    }

    /// <summary>Adds a triangle; one with two equal corners has no area, and is left out.</summary>
    public void Add(int a, int b, int c)
    {
        if (a == b || b == c || c == a)
        {
            Collapsed++;
            return;
        }

        MustFit((Triangles.Count / 3) + 1L);
        Triangles.AddRange([a, b, c]);
    }

    /// <summary>Refuses too many triangles.</summary>
    public void MustFit(long triangles)
    {
        if (triangles > MeshFile.MostTriangles)
            throw new InputException($"{path}: must have at most {MeshFile.MostTriangles} triangles, and has more");
    }

    /// <summary>The error at a place of the file.</summary>
    public InputException Wrong(string place, string what) => new(place.Length > 0 ? $"{path}: {place}: {what}" : $"{path}: {what}");

    // hashes are seeded in every process, so that no file can be made whose corners all collide
    private sealed class ByBits : IEqualityComparer<Vector3d>
    {
        public bool Equals(Vector3d a, Vector3d b) => a == b;

        public int GetHashCode([DisallowNull] Vector3d v) => HashCode.Combine(v.X, v.Y, v.Z);
    }
}
