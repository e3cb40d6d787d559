using System.Formats.Tar;
using System.IO.Compression;
using System.Text;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>
/// Writes a .unitypackage: a gzipped tar with a folder per asset, named by its GUID, that holds the file, its meta and its
/// path. Plain ustar and a gzip header without a name: with a name in it Unity on Windows shows an empty package. The
/// same assets give the same bytes on every system.
/// </summary>
internal static class PackageWriter
{
    private const UnixFileMode FileMode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead;
    private const UnixFileMode FolderMode = FileMode | UnixFileMode.UserExecute | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute;

    // the byte of a gzip header that names the system; the editor writes 0
    private const int SystemByte = 9;

    /// <summary>The package as bytes.</summary>
    /// <param name="assets">In the order of their GUIDs.</param>
    public static byte[] Write(IReadOnlyList<Asset> assets)
    {
        MemoryStream packed = new();
        using (GZipStream zip = new(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            using TarWriter tar = new(zip, TarEntryFormat.Ustar);
            foreach (Asset asset in assets)
            {
                Add(tar, TarEntryType.Directory, asset.Guid + "/", null);
                if (asset.Content != null)
                    Add(tar, TarEntryType.RegularFile, asset.Guid + "/asset", asset.Content);

                Add(tar, TarEntryType.RegularFile, asset.Guid + "/asset.meta", asset.Meta);
                Add(tar, TarEntryType.RegularFile, asset.Guid + "/pathname", Encoding.UTF8.GetBytes(asset.Path));
            }
        }

        byte[] bytes = packed.ToArray();
        bytes[SystemByte] = 0;
        return bytes;
    }

    private static void Add(TarWriter tar, TarEntryType type, string name, byte[]? content)
    {
        UstarTarEntry entry = new(type, name)
        {
            Mode = content == null ? FolderMode : FileMode,
            ModificationTime = DateTimeOffset.UnixEpoch,
        };
        if (content != null)
            entry.DataStream = new MemoryStream(content);

        tar.WriteEntry(entry);
    }
}
