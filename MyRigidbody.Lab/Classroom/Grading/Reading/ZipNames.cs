using System.IO.Compression;
using System.Text;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>Opens a zip whose names may be in GBK, as Chinese Windows writes them, or in UTF-8 without saying so, as macOS does.</summary>
internal static class ZipNames
{
    /// <summary>The archive, with its names decoded.</summary>
    public static ZipArchive Open(byte[] bytes)
    {
        // names without the UTF-8 flag appear byte by byte here
        using ZipArchive raw = new(new MemoryStream(bytes), ZipArchiveMode.Read, leaveOpen: false, Encoding.Latin1);
        byte[] names = [.. raw.Entries
            .Select(entry => entry.FullName)
            .Where(name => name.All(letter => letter <= 0xff))
            .Take(Limits.Entries)
            .SelectMany(Encoding.Latin1.GetBytes)];
        return new ZipArchive(new MemoryStream(bytes), ZipArchiveMode.Read, leaveOpen: false, SourceText.Decode(names).Encoding == "UTF-8" ? Encoding.UTF8 : SourceText.Gbk);
    }
}
