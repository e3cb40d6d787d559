using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Vertices, not scaled.</summary>
    public sealed class Mesh : Object
    {
        private Vector3[] _vertices = new Vector3[0];

        public Vector3[] vertices
        {
            get => (Vector3[])_vertices.Clone();
            set => _vertices = (Vector3[])value.Clone();
        }

        public int vertexCount => _vertices.Length;

        public bool isReadable { get; internal set; } = true;

        /// <summary>Unity's own cube: three vertices in each corner, one for every face that meets there.</summary>
        internal static Mesh Cube()
        {
            List<Vector3> vertices = new List<Vector3>();
            for (int axis = 0; axis < 3; axis++)
            {
                for (int corner = 0; corner < 8; corner++)
                    vertices.Add(new Vector3((corner & 1) - 0.5f, ((corner >> 1) & 1) - 0.5f, ((corner >> 2) & 1) - 0.5f));
            }

            return new Mesh { name = "Cube", vertices = vertices.ToArray() };
        }
    }
}
