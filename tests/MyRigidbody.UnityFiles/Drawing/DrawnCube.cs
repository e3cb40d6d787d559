using System.Numerics;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>Unity's built-in cube, with the size and orientation of its object.</summary>
/// <param name="Name">The name of its object.</param>
/// <param name="Parent">The name of the object that it is a part of; null if it is none.</param>
/// <param name="World">From its own axes to those of the world.</param>
/// <param name="Color">Red, green and blue of its material, 0 to 1.</param>
public sealed record DrawnCube(string Name, string? Parent, Matrix4x4 World, Vector3 Color)
{
    /// <summary>Its eight corners in the world; bits 0, 1 and 2 of an index are its sides along x, y and z.</summary>
    public Vector3[] Corners => [.. Enumerable.Range(0, 8).Select(i => Vector3.Transform(new Vector3(Side(i, 0), Side(i, 1), Side(i, 2)), World))];

    /// <summary>Its centre in the world.</summary>
    public Vector3 Center => World.Translation;

    /// <summary>Its six faces, each with four corners in order.</summary>
    public IEnumerable<Vector3[]> Faces
    {
        get
        {
            Vector3[] corners = Corners;
            for (int axis = 0; axis < 3; axis++)
            {
                int a = 1 << axis, b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
                yield return [corners[0], corners[b], corners[b | c], corners[c]];
                yield return [corners[a], corners[a | b], corners[a | b | c], corners[a | c]];
            }
        }
    }

    private static float Side(int corner, int axis) => (corner >> axis & 1) - 0.5f;
}
