using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>The unscaled vertices of a mesh.</summary>
    public sealed class Mesh : Object
    {
        private Vector3[] _vertices = new Vector3[0];

        public Vector3[] vertices
        {
            get => (Vector3[])_vertices.Clone();
            set => _vertices = (Vector3[])value.Clone();
        }

        /// <summary>Three vertex numbers of each triangle.</summary>
        public int[] triangles { get; set; } = new int[0];

        public Vector3[] normals { get; set; } = new Vector3[0];

        /// <summary>The bounding box of all vertices, in the object's axes.</summary>
        public Bounds bounds => Bounds.Round(_vertices);

        public int vertexCount => _vertices.Length;

        public bool isReadable { get; internal set; } = true;

        public void GetVertices(List<Vector3> vertices)
        {
            vertices.Clear();
            vertices.AddRange(_vertices);
        }

        public void RecalculateBounds() { }

        public void RecalculateNormals() { }

        internal Mesh Copy() => new Mesh { name = name + " Instance", vertices = _vertices, triangles = triangles, normals = normals };

        /// <summary>Unity's own cube: three vertices in each corner, one for each face there.</summary>
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
