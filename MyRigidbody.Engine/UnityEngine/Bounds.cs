namespace UnityEngine
{
    /// <summary>A box along the axes.</summary>
    public struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size)
        {
            this.center = center;
            extents = size * 0.5f;
        }

        public Vector3 center { get; set; }

        /// <summary>Half of the edges.</summary>
        public Vector3 extents { get; set; }

        public Vector3 size { get => extents * 2; set => extents = value * 0.5f; }

        public Vector3 min => center - extents;

        public Vector3 max => center + extents;

        /// <summary>The bounding box of points.</summary>
        internal static Bounds Round(Vector3[] points)
        {
            if (points.Length == 0)
                return new Bounds();

            Vector3 least = points[0], most = points[0];
            foreach (Vector3 point in points)
            {
                least = Vector3.Min(least, point);
                most = Vector3.Max(most, point);
            }

            return new Bounds((least + most) * 0.5f, most - least);
        }
    }
}
