using System.Buffers.Binary;
using System.Globalization;

namespace RigidBodyDynamics.Lab.Meshes;

/// <summary>
/// Reads STL, binary or ASCII (3D Systems, Stereolithography Interface Specification, 1988). Normals are ignored: the order of
/// the corners gives them.
/// </summary>
internal static class StlReader
{
    private const int Header = 80, Start = Header + 4, BytesOfTriangle = 50, BytesOfVector = 12;

    /// <summary>Reads a file. Some binary files begin with "solid", as ASCII ones do, so the length decides.</summary>
    public static void Read(ReadOnlySpan<byte> file, MeshBuilder mesh)
    {
        long count = file.Length >= Start ? BinaryPrimitives.ReadUInt32LittleEndian(file[Header..]) : 0;
        if (file.Length >= Start && Start + (BytesOfTriangle * count) == file.Length)
        {
            mesh.MustFit(count);
            Numbers(file[Start..], mesh);
            return;
        }

        Words words = new(file);
        if (words.Next() && words.Is("solid"))
        {
            Text(words, mesh);
            return;
        }

        throw mesh.Wrong(string.Empty, file.Length < Start
            ? $"is no STL: it does not begin with \"solid\", and {file.Length} bytes are too few for one in numbers"
            : string.Create(CultureInfo.InvariantCulture, $"is no STL, or is cut off: {count} triangles take {Start + (BytesOfTriangle * count)} bytes, and it has {file.Length}"));
    }

    private static void Numbers(ReadOnlySpan<byte> triangles, MeshBuilder mesh)
    {
        for (int number = 1; triangles.Length > 0; triangles = triangles[BytesOfTriangle..], number++)
        {
            mesh.Add(Corner(triangles, 1), Corner(triangles, 2), Corner(triangles, 3));

            // the first vector is the normal
            int Corner(ReadOnlySpan<byte> triangle, int index)
            {
                ReadOnlySpan<byte> at = triangle[(index * BytesOfVector)..];
                Vector3d corner = new(
                    BinaryPrimitives.ReadSingleLittleEndian(at), BinaryPrimitives.ReadSingleLittleEndian(at[4..]), BinaryPrimitives.ReadSingleLittleEndian(at[8..]));
                return mesh.Vertex(corner, corner.IsFinite ? string.Empty : $"triangle {number}");
            }
        }
    }

    private static void Text(Words words, MeshBuilder mesh)
    {
        do
        {
            // the name may be any words
            words.SkipLine();
            Must(ref words, words.Next(), "facet or endsolid");
            while (words.Is("facet"))
            {
                Expect(ref words, "normal");
                for (int i = 0; i < 3; i++)
                    Must(ref words, words.Next(), "a number");

                Expect(ref words, "outer");
                Expect(ref words, "loop");
                int a = Corner(ref words), b = Corner(ref words), c = Corner(ref words);
                mesh.Add(a, b, c);
                Expect(ref words, "endloop");
                Expect(ref words, "endfacet");
                Must(ref words, words.Next(), "facet or endsolid");
            }

            Must(ref words, words.Is("endsolid"), "facet or endsolid");
            words.SkipLine();
            if (!words.Next())
                return;

            Must(ref words, words.Is("solid"), "solid or the end of the file");
        }
        while (true);

        int Corner(ref Words words)
        {
            Expect(ref words, "vertex");
            Vector3d corner = new(Number(ref words), Number(ref words), Number(ref words));
            return mesh.Vertex(corner, corner.IsFinite ? string.Empty : words.Place);
        }

        double Number(ref Words words)
        {
            double number = 0;
            Must(ref words, words.Next() && words.IsNumber(out number), "a number");
            return number;
        }

        void Expect(ref Words words, string keyword) => Must(ref words, words.Next() && words.Is(keyword), keyword);

        void Must(ref Words words, bool isThere, string what)
        {
            if (!isThere)
                throw mesh.Wrong(words.Place, $"must be {what}, found {words.Shown}");
        }
    }
}
