using System.Buffers.Text;
using System.Globalization;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>
/// Reads the positions (v) and faces (f) of OBJ (Wavefront, Advanced Visualizer, appendix B, 1995). All groups and objects are one surface; a
/// face of more than three corners is split into a fan. Textures, normals, materials and lines are ignored; free-form surfaces are refused.
/// </summary>
internal static class ObjReader
{
    public static void Read(ReadOnlySpan<byte> file, MeshBuilder mesh)
    {
        // numbers of the merged vertices, in the order of the file
        List<int> vertices = [];
        Words words = new(file);
        while (words.Next())
        {
            if (words.Is("v"))
            {
                double x = 0, y = 0, z = 0;
                bool isVertex = words.NextInLine() && words.IsNumber(out x) && words.NextInLine() && words.IsNumber(out y) && words.NextInLine() && words.IsNumber(out z);
                vertices.Add(isVertex ? mesh.Vertex(new Vector3d(x, y, z), words.Place) : throw mesh.Wrong(words.Place, $"v must have three numbers, found {words.Shown}"));
            }
            else if (words.Is("f"))
            {
                Face(ref words);
            }
            else if (IsFreeForm(words))
            {
                throw mesh.Wrong(words.Place, $"{words.Shown} is of a free-form surface, which is not understood: export triangles");
            }

            words.SkipLine();
        }

        void Face(ref Words words)
        {
            int first = 0, last = 0, corners = 0;
            while (words.NextInLine() && words.Word[0] != '#')
            {
                int corner = Corner(ref words);
                if (corners == 0)
                    first = corner;
                else if (corners > 1)
                    mesh.Add(first, last, corner);

                last = corner;
                corners++;
            }

            if (corners < 3)
                throw mesh.Wrong(words.Place, string.Create(CultureInfo.InvariantCulture, $"f must have at least three corners, found {corners}"));
        }

        int Corner(ref Words words)
        {
            // position/texture/normal; from 1, or backwards from the last
            if (!Utf8Parser.TryParse(words.Word, out int number, out int length) || (length < words.Word.Length && words.Word[length] != '/'))
                throw mesh.Wrong(words.Place, $"a corner of f must be the number of a v, found {words.Shown}");

            long index = number < 0 ? vertices.Count + (long)number : number - 1L;
            return index >= 0 && index < vertices.Count
                ? vertices[(int)index]
                : throw mesh.Wrong(words.Place, string.Create(CultureInfo.InvariantCulture, $"there is no vertex {number}: {vertices.Count} stand above"));
        }
    }

    private static bool IsFreeForm(Words words) => words.Is("cstype") || words.Is("curv") || words.Is("surf");
}
