using System.Formats.Tar;
using System.IO.Compression;
using System.Text;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>Reads a .unitypackage, as Unity does: first the path of each GUID, then the files.</summary>
internal static class PackageReader
{
    // a package of ours has a thousandth of it
    private const int MostBytes = 1 << 28;

    /// <summary>The assets of a package; any error in it is an <see cref="InputException"/>.</summary>
    public static IReadOnlyList<Asset> Read(string path)
    {
        try
        {
            using FileStream file = File.OpenRead(path);
            return Read(path, file);
        }
        catch (Exception refused) when (refused is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"{path}: cannot be read: {refused.Message.ReplaceLineEndings(" ")}");
        }
        catch (Exception size) when (size is ArgumentOutOfRangeException or OverflowException)
        {
            throw new InputException($"{path}: is no Unity package: a header names a size that the file does not have");
        }
        catch (Exception wrong) when (wrong is InvalidDataException or FormatException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"{path}: is no Unity package: {wrong.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static List<Asset> Read(string path, Stream packed)
    {
        SortedDictionary<string, Dictionary<string, byte[]>> folders = new(StringComparer.Ordinal);
        using TarReader tar = new(Unpacked(packed));
        while (tar.GetNextEntry(copyData: false) is TarEntry entry)
        {
            string[] parts = entry.Name.TrimEnd('/').Split('/');
            parts = parts[0] == "." ? parts[1..] : parts;
            if (entry.EntryType is TarEntryType.Directory || parts.Length != 2)
                continue;

            if (entry.EntryType is not (TarEntryType.RegularFile or TarEntryType.V7RegularFile))
                throw new InvalidDataException($"{entry.Name} is no file but a {entry.EntryType}");

            if (!folders.TryGetValue(parts[0], out Dictionary<string, byte[]>? files))
                folders[parts[0]] = files = [];

            MemoryStream content = new();
            entry.DataStream?.CopyTo(content);
            files[parts[1]] = content.ToArray();
        }

        return [.. folders.Select(folder => Asset(path, folder.Key, folder.Value))];
    }

    /// <summary>Unpacks all of it within a limit before reading, because headers may contain names of a gigabyte.</summary>
    private static MemoryStream Unpacked(Stream packed)
    {
        using GZipStream zip = new(packed, CompressionMode.Decompress);
        MemoryStream tar = new();
        byte[] piece = new byte[1 << 16];
        for (int read; (read = zip.Read(piece)) > 0;)
        {
            tar.Write(piece, 0, read);
            if (tar.Length > MostBytes)
                throw new InvalidDataException($"it unpacks to more than {MostBytes} bytes");
        }

        tar.Position = 0;
        return tar;
    }

    private static Asset Asset(string path, string guid, Dictionary<string, byte[]> files)
    {
        byte[] File(string name) => files.GetValueOrDefault(name) ?? throw new InputException($"{path}: {guid}: has no {name}");

        // some editors write a second line, which none reads
        string inProject = Encoding.UTF8.GetString(File("pathname")).Split('\n')[0].TrimEnd('\r');
        return new Asset(inProject, guid, files.GetValueOrDefault("asset"), File("asset.meta"));
    }
}
