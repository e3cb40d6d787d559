using UnityEngine;

// 把对象的缩放乘进网格的顶点，这样 mesh.vertices 就是 1 × 2 × 3 长方体真正的顶点，I_ref 才是它的转动惯量。
// Puts the scale of the object into the vertices of its mesh: then mesh.vertices are those of the 1 × 2 × 3 box, and I_ref is its inertia.
[RequireComponent(typeof(MeshFilter))]
public class BoxMesh : MonoBehaviour
{
    void Awake()
    {
        Mesh mesh = GetComponent<MeshFilter>().mesh;
        Vector3[] vertices = mesh.vertices;
        for (int i = 0; i < vertices.Length; i++)
            vertices[i] = Vector3.Scale(vertices[i], transform.localScale);
        mesh.vertices = vertices;
        mesh.RecalculateBounds();
        transform.localScale = Vector3.one;
    }
}
