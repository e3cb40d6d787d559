using System.Formats.Tar;
using System.IO.Compression;
using System.Text;
using RigidBodyDynamics.Lab.Grading.Reading;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>Packages and archives of students, and hostile ones.</summary>
internal static class Archives
{
    /// <summary>A script that says what it is.</summary>
    public const string Source = "public class MyRigidbody : UnityEngine.MonoBehaviour { }";

    /// <summary>What a file of a name and content gives.</summary>
    public static IReadOnlyList<Piece> Read(string name, byte[] bytes) => Reader.Read(new Spot(name, [name]), bytes);

    /// <summary>A Unity package with files by their paths.</summary>
    public static byte[] Package(params (string Path, string Content)[] files) => Zipped(Tar(files));

    /// <summary>The same before it is compressed.</summary>
    public static byte[] Tar(params (string Path, string Content)[] files)
    {
        MemoryStream bytes = new();
        using (TarWriter tar = new(bytes, TarEntryFormat.Ustar, leaveOpen: true))
        {
            for (int i = 0; i < files.Length; i++)
            {
                string guid = i.ToString("x32", null);
                Add(tar, guid + "/asset", Encoding.UTF8.GetBytes(files[i].Content));
                Add(tar, guid + "/asset.meta", Encoding.UTF8.GetBytes("guid: " + guid));
                Add(tar, guid + "/pathname", Encoding.UTF8.GetBytes(files[i].Path));
            }
        }

        return bytes.ToArray();
    }

    /// <summary>By gzip.</summary>
    public static byte[] Zipped(byte[] bytes)
    {
        MemoryStream packed = new();
        using (GZipStream zip = new(packed, CompressionLevel.Fastest, leaveOpen: true))
            zip.Write(bytes);

        return packed.ToArray();
    }

    /// <summary>A zip with files by their names.</summary>
    public static byte[] Zip(params (string Name, byte[] Content)[] files) => Zip(Encoding.UTF8, files);

    public static byte[] Zip(Encoding names, params (string Name, byte[] Content)[] files)
    {
        MemoryStream bytes = new();
        using (ZipArchive zip = new(bytes, ZipArchiveMode.Create, leaveOpen: true, names))
        {
            foreach ((string name, byte[] content) in files)
            {
                using Stream entry = zip.CreateEntry(name, CompressionLevel.Fastest).Open();
                entry.Write(content);
            }
        }

        return bytes.ToArray();
    }

    public static byte[] Bytes(string text) => Encoding.UTF8.GetBytes(text);

    public static void Add(TarWriter tar, string name, byte[] content) =>
        tar.WriteEntry(new UstarTarEntry(TarEntryType.RegularFile, name) { DataStream = new MemoryStream(content) });
}
