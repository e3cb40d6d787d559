using System.IO.Compression;

namespace RigidBodyDynamics.Web.Building;

/// <summary>What goes over the wire is packed once, when the site is built.</summary>
internal static class Packing
{
    /// <summary>
    /// How the name of a file ends that is packed by gzip whatever the server does, and that the page unpacks: assemblies and
    /// WebAssembly. No server takes a .bin for something to refuse, to pack again or to unpack.
    /// </summary>
    public const string Always = ".bin";

    /// <summary>What browsers accept, by the ending of the file beside the plain one.</summary>
    public static readonly (string Ending, Func<Stream, Stream> Pack)[] Encodings =
        [(".br", to => new BrotliStream(to, CompressionLevel.SmallestSize)), (".gz", Gzip)];

    /// <summary>Packs a file that the page unpacks.</summary>
    public static void Pack(string source, string target) => Write(source, target, Gzip);

    /// <summary>Packs a text beside itself, for servers that send it so to a browser that accepts it.</summary>
    /// <returns>The files.</returns>
    public static IEnumerable<string> PackBeside(string file)
    {
        DateTime time = File.GetLastWriteTimeUtc(file);
        foreach ((string ending, Func<Stream, Stream> pack) in Encodings)
        {
            string packed = file + ending;
            if (!File.Exists(packed) || File.GetLastWriteTimeUtc(packed) != time)
            {
                Write(file, packed, pack);
                File.SetLastWriteTimeUtc(packed, time);
            }

            yield return packed;
        }
    }

    private static GZipStream Gzip(Stream to) => new(to, CompressionLevel.SmallestSize);

    private static void Write(string source, string target, Func<Stream, Stream> pack)
    {
        using FileStream from = File.OpenRead(source), to = File.Create(target);
        using Stream packed = pack(to);
        from.CopyTo(packed);
    }
}
