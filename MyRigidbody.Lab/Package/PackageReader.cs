using System.Formats.Tar;
using System.IO.Compression;
using System.Text;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>Reads a .unitypackage, as Unity does: first which GUID has which path, then the files.</summary>
internal static class PackageReader
{
    // a package of ours is a thousandth of it
    private const int MostBytes = 1 << 28;

    /// <summary>The assets of a package; all that can be wrong with it is an <see cref="InputException"/>.</summary>
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
        catch (Exception wrong) when (wrong is InvalidDataException or FormatException or ArgumentException or OverflowException or NotSupportedException)
        {
            throw new InputException($"{path}: is no Unity package: {wrong.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static List<Asset> Read(string path, Stream packed)
    {
        SortedDictionary<string, Dictionary<string, byte[]>> folders = new(StringComparer.Ordinal);
        using GZipStream zip = new(packed, CompressionMode.Decompress);
        using TarReader tar = new(zip);
        long bytes = 0;
        while (tar.GetNextEntry(copyData: false) is TarEntry entry)
        {
            string[] parts = entry.Name.TrimEnd('/').Split('/');
            parts = parts[0] == "." ? parts[1..] : parts;
            if (entry.EntryType is TarEntryType.Directory || parts.Length != 2)
                continue;

            if ((bytes += entry.Length) > MostBytes)
                throw new InvalidDataException($"it unpacks to more than {MostBytes} bytes");

            if (!folders.TryGetValue(parts[0], out Dictionary<string, byte[]>? files))
                folders[parts[0]] = files = [];

            MemoryStream content = new();
            entry.DataStream?.CopyTo(content);
            files[parts[1]] = content.ToArray();
        }

        return [.. folders.Select(folder => Asset(path, folder.Key, folder.Value))];
    }

    private static Asset Asset(string path, string guid, Dictionary<string, byte[]> files)
    {
        byte[] File(string name) => files.GetValueOrDefault(name) ?? throw new InputException($"{path}: {guid}: has no {name}");

        return new Asset(Encoding.UTF8.GetString(File("pathname")), guid, files.GetValueOrDefault("asset"), File("asset.meta"));
    }
}
