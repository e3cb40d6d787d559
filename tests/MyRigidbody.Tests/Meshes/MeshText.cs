using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Tests;

/// <summary>Surfaces as files say them.</summary>
internal static class MeshText
{
    /// <summary>OBJ, with vertices by number.</summary>
    public static string Obj(Surface surface) => string.Concat(
        surface.Vertices.Select(v => Line($"v {v.X:R} {v.Y:R} {v.Z:R}")).Concat(surface.Triangles.Chunk(3).Select(t => Line($"f {t[0] + 1} {t[1] + 1} {t[2] + 1}"))));

    /// <summary>STL in words, with every corner of every triangle anew.</summary>
    public static string Stl(Surface surface) => "solid part of a thing\n" + string.Concat(surface.Triangles.Chunk(3).Select(t =>
        "facet normal 0 0 0\nouter loop\n" + string.Concat(t.Select(i => Line($"vertex {surface.Vertices[i].X:R} {surface.Vertices[i].Y:R} {surface.Vertices[i].Z:R}")))
        + "endloop\nendfacet\n")) + "endsolid part of a thing\n";

    /// <summary>STL in numbers, in single precision; the header begins like a file in words, as some programs write it.</summary>
    public static byte[] BinaryStl(Surface surface)
    {
        using MemoryStream file = new();
        using BinaryWriter writer = new(file);
        writer.Write(Encoding.ASCII.GetBytes("solid exported".PadRight(80)));
        writer.Write(surface.Triangles.Length / 3);
        for (int i = 0; i < surface.Triangles.Length; i++)
        {
            if (i % 3 == 0)
                writer.Write(new byte[12]);

            Vector3d v = surface.Vertices[surface.Triangles[i]];
            writer.Write((float)v.X);
            writer.Write((float)v.Y);
            writer.Write((float)v.Z);
            if (i % 3 == 2)
                writer.Write((short)0);
        }

        return file.ToArray();
    }

    private static string Line(FormattableString text) => text.ToString(CultureInfo.InvariantCulture) + "\n";
}
