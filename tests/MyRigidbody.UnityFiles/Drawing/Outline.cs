using System.Numerics;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>The convex outline of a cube in a picture.</summary>
public static class Outline
{
    /// <summary>Its corners in order, pixels from the left and from the top.</summary>
    public static Vector2[] Of(DrawnCube cube, Viewpoint view, int width, int height) => Hull(
        [.. cube.Corners.Select(corner => view.Project(corner, width, height)).Select(p => new Vector2(p.X, p.Y)).OrderBy(p => p.X).ThenBy(p => p.Y)]);

    /// <summary>True if two convex outlines have a point in common: no edge of either has the other wholly outside.</summary>
    public static bool Overlap(Vector2[] a, Vector2[] b) => !HasEdgeBetween(a, b) && !HasEdgeBetween(b, a);

    private static bool HasEdgeBetween(Vector2[] a, Vector2[] b) => Enumerable.Range(0, a.Length).Any(i =>
    {
        Vector2 from = a[i], along = a[(i + 1) % a.Length] - from;
        float own = a.Select(p => Cross(along, p - from)).MaxBy(MathF.Abs);
        return b.All(p => Cross(along, p - from) * own < 0);
    });

    // half of the outline from left to right, the other half back
    private static Vector2[] Hull(Vector2[] sorted) => [.. Half(sorted), .. Half([.. sorted.Reverse()])];

    private static List<Vector2> Half(Vector2[] sorted)
    {
        List<Vector2> half = [];
        foreach (Vector2 p in sorted)
        {
            while (half.Count > 1 && Cross(half[^1] - half[^2], p - half[^1]) <= 0)
                half.RemoveAt(half.Count - 1);

            half.Add(p);
        }

        half.RemoveAt(half.Count - 1);
        return half;
    }

    private static float Cross(Vector2 a, Vector2 b) => a.X * b.Y - a.Y * b.X;
}
