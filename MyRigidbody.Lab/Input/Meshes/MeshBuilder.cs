using System.Diagnostics.CodeAnalysis;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>
/// Puts triangles together. Corners of the same three numbers, to the last bit, are one vertex: files write a corner anew for every
/// triangle, and write it alike.
/// </summary>
internal sealed class MeshBuilder(string path)
{
    private readonly Dictionary<Vector3d, int> _known = new(new ByBits());

    /// <summary>Each position once.</summary>
    public List<Vector3d> Vertices { get; } = [];

    /// <summary>Three numbers of vertices a triangle.</summary>
    public List<int> Triangles { get; } = [];

    /// <summary>How many triangles had two equal corners.</summary>
    public int Collapsed { get; private set; }

    /// <summary>The number of the vertex at a position.</summary>
    public int Vertex(Vector3d position, string place)
    {
        if (!position.IsFinite)
        {
            throw Wrong(place, "a corner must have three finite numbers, found " + position);
        }

        // minus zero is zero
        position += Vector3d.Zero;
        if (_known.TryGetValue(position, out int number))
        {
            return number;
        }

        _known.Add(position, Vertices.Count);
        Vertices.Add(position);
        return Vertices.Count - 1;
    }

    /// <summary>A triangle; one with two equal corners is a line, whose two edges cancel, and is left out.</summary>
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
        {
            throw new InputException($"{path}: must have at most {MeshFile.MostTriangles} triangles, and has more");
        }
    }

    /// <summary>The error that says what is wrong at a place of the file.</summary>
    public InputException Wrong(string place, string what) => new(place.Length > 0 ? $"{path}: {place}: {what}" : $"{path}: {what}");

    // with a seed of its own in every process: no file can be made whose corners all meet in one slot
    private sealed class ByBits : IEqualityComparer<Vector3d>
    {
        public bool Equals(Vector3d a, Vector3d b) => a == b;

        public int GetHashCode([DisallowNull] Vector3d v) => HashCode.Combine(v.X, v.Y, v.Z);
    }
}
