using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The objects of the experiments.</summary>
    internal static class Settings
    {
        /// <summary>Unity's cube beside the origin, as in the sheet's scene: its inertia tensor is the same in all axes.</summary>
        public static readonly Setting Cube = new Setting(
            new Pose(new Vector(2, 0, 0), Orientation.Identity), new Vector(1, 1, 1), Box(new Vector(1, 1, 1)));

        /// <summary>A rotated box of 1 × 2 × 3 m: it distinguishes R from its transpose, and the order of a product.</summary>
        public static readonly Setting TurnedBox = new Setting(
            new Pose(new Vector(-1, 0.5, 2), new Orientation(0.3, -0.5, 0.4, 0.7).Normalized), new Vector(1, 1, 1), Box(new Vector(1, 2, 3)));

        /// <summary>Three vertices in each corner, one for each face there.</summary>
        private static IReadOnlyList<Vector> Box(Vector edges)
        {
            List<Vector> vertices = new List<Vector>();
            for (int i = 0; i < 24; i++)
                vertices.Add(new Vector(Half(i, edges.X), Half(i >> 1, edges.Y), Half(i >> 2, edges.Z)));
            return vertices;
        }

        private static double Half(int bits, double edge) => ((bits & 1) - 0.5) * edge;
    }
}
