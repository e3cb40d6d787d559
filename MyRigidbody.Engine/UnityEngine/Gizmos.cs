using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Lines in the Scene view.</summary>
    public static class Gizmos
    {
        public static Color color { get; set; } = Color.white;

        /// <summary>The rays drawn in this frame.</summary>
        internal static List<(Color Color, Vector3 From, Vector3 Direction)> Rays { get; } = new List<(Color, Vector3, Vector3)>();

        public static void DrawRay(Vector3 from, Vector3 direction) => Rays.Add((color, from, direction));

        public static void DrawSphere(Vector3 center, float radius) { }
    }
}
