using System.IO.Compression;

namespace RigidBodyDynamics.Web.Building;

/// <summary>Compresses the files of the site once, when it is built.</summary>
internal static class Packing
{
    /// <summary>
    /// The extension of files that are always compressed by gzip and that the page decompresses: assemblies and WebAssembly. A server
    /// neither refuses, compresses nor decompresses a .bin.
    /// </summary>
    public const string Always = ".bin";

    /// <summary>The compressions that browsers accept, by the extension of the file beside the plain one.</summary>
    public static readonly (string Ending, Func<Stream, Stream> Pack)[] Encodings =
        [(".br", to => new BrotliStream(to, CompressionLevel.SmallestSize)), (".gz", Gzip)];

    /// <summary>Compresses a file that the page decompresses.</summary>
    public static void Pack(string source, string target) => Write(source, target, Gzip);

    /// <summary>Writes compressed copies of a text beside it, for servers that send them to browsers that accept them.</summary>
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
