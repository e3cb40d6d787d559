using System.Formats.Tar;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>The file that a path leads to, and whether it is one.</summary>
internal static class RealPath
{
    private static readonly StringComparison Letters = OperatingSystem.IsLinux() ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase;

    /// <summary>The path without links, including those of folders; a path that does not exist is returned as given.</summary>
    public static string Of(string path)
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(path));
        if (Path.GetDirectoryName(full) is not string folder)
            return full;

        string here = Path.Combine(Of(folder), Path.GetFileName(full));
        return new FileInfo(here).LinkTarget == null ? here : Of(Target(here));
    }

    private static string Target(string link)
    {
        try
        {
            return File.ResolveLinkTarget(link, returnFinalTarget: true)!.FullName;
        }
        catch (IOException)
        {
            // circular links lead nowhere
            return Path.GetPathRoot(link)!;
        }
    }

    /// <summary>True if two paths lead to one file or folder.</summary>
    public static bool Same(string one, string other) => string.Equals(Of(one), Of(other), Letters);

    /// <summary>True for a file with content: no link, no pipe, no device.</summary>
    public static bool IsPlainFile(string path)
    {
        FileInfo file = new(path);
        if (!file.Exists || file.LinkTarget != null)
            return false;

        return OperatingSystem.IsWindows() || file.Length > 0 || IsEmptyFile(path);
    }

    /// <summary>Pipes and devices have length zero, too; only the library's tar distinguishes them without opening.</summary>
    private static bool IsEmptyFile(string path)
    {
        try
        {
            using MemoryStream archive = new();
            using (TarWriter writer = new(archive, TarEntryFormat.Pax, leaveOpen: true))
            {
                writer.WriteEntry(path, "entry");
            }

            archive.Position = 0;
            using TarReader reader = new(archive);
            return reader.GetNextEntry()?.EntryType == TarEntryType.RegularFile;
        }
        catch (UnauthorizedAccessException)
        {
            // only plain files are opened
            return true;
        }
        catch (IOException)
        {
            return false;
        }
    }
}
