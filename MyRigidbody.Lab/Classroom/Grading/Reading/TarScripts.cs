using System.Formats.Tar;
using System.IO.Compression;
using System.Text;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>
/// The scripts of a Unity package, read in two passes: first the path of each GUID, then the scripts among them. So nothing else
/// is kept in memory, and nothing is unpacked to disk. A plain tar of folders is read, too.
/// </summary>
internal static class TarScripts
{
    /// <summary>The package at a place.</summary>
    /// <param name="spot">Where it is.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="notes">Problems that are already known.</param>
    public static Piece Read(Spot spot, byte[] bytes, IEnumerable<Finding> notes)
    {
        List<Finding> noted = [.. notes];
        try
        {
            Dictionary<string, string> paths = Paths(bytes, noted);
            return new Piece(spot, true, [.. Scripts(spot, bytes, paths, noted)], null, noted);
        }
        catch (TooLargeException large)
        {
            return Piece.Unreadable(spot, Problems.TooLarge(large.Limit));
        }
        catch (TooManyException)
        {
            return Piece.Unreadable(spot, Problems.TooManyEntries());
        }
        catch (Exception cut) when (cut is EndOfStreamException || (cut is InvalidDataException && IsCut(bytes)))
        {
            return Piece.Unreadable(spot, Problems.Truncated());
        }
        catch (Exception damaged) when (damaged is InvalidDataException or IOException or FormatException or ArgumentException or OverflowException or NotSupportedException)
        {
            return Piece.Unreadable(spot, Problems.Damaged(damaged.Message));
        }
    }

    /// <summary>Path by the entry that holds its content.</summary>
    private static Dictionary<string, string> Paths(byte[] bytes, List<Finding> notes)
    {
        Dictionary<string, string> unity = [], plain = [];
        foreach (TarEntry entry in Entries(bytes, notes))
        {
            string name = Clean(entry.Name);
            if (entry.EntryType is TarEntryType.SymbolicLink or TarEntryType.HardLink)
            {
                notes.Add(Problems.Link(name));
            }
            else if (entry.DataStream is Stream data && name.EndsWith("/pathname", StringComparison.Ordinal))
            {
                // Unity 5 and older wrote a second line
                string path = Encoding.UTF8.GetString(CountedStream.ReadAll(data, Limits.PathName)).Split('\n')[0].Trim('\r', '\0', ' ');
                unity[name[..^"pathname".Length] + "asset"] = path;
            }
            else if (IsFile(entry) && FileKinds.IsScript(name))
            {
                plain[name] = name;
            }
        }

        Dictionary<string, string> paths = unity.Count > 0 ? unity : plain;
        foreach (string path in paths.Values.Where(path => path.Split('/', '\\').Contains("..") || path.StartsWith('/') || path.Contains(':')))
            notes.Add(Problems.PathOutside(path));

        return paths;
    }

    private static List<Script> Scripts(Spot spot, byte[] bytes, Dictionary<string, string> paths, List<Finding> notes)
    {
        List<Script> scripts = [];
        foreach (TarEntry entry in Entries(bytes, []))
        {
            if (!IsFile(entry) || !paths.TryGetValue(Clean(entry.Name), out string? path) || !FileKinds.IsScript(path))
                continue;

            if (entry.Length > Limits.Script)
            {
                notes.Add(Problems.ScriptTooLarge(path));
            }
            else if (scripts.Count == Limits.Scripts)
            {
                notes.Add(Problems.TooManyScripts());
                break;
            }
            else
            {
                scripts.Add(new Script(spot.InArchive(path), CountedStream.ReadAll(entry.DataStream ?? Stream.Null, Limits.Script)));
            }
        }

        return scripts;
    }

    /// <summary>All entries; with a note if the data after the last one is damaged.</summary>
    private static IEnumerable<TarEntry> Entries(byte[] bytes, List<Finding> notes)
    {
        using Stream unpacked = new CountedStream(
            FileKinds.Of(bytes) == FileKind.Gzip ? new GZipStream(new MemoryStream(bytes), CompressionMode.Decompress) : new MemoryStream(bytes), Limits.Unpacked);
        using TarReader tar = new(unpacked);
        for (int count = 0; tar.GetNextEntry(copyData: false) is TarEntry entry; count++)
        {
            if (count == Limits.Entries)
                throw new TooManyException();

            yield return entry;
        }

        // the checksum of a gzip follows the tar
        if (!IsReadToItsEnd(unpacked))
            notes.Add(Problems.Checksum());
    }

    private static bool IsReadToItsEnd(Stream stream)
    {
        try
        {
            stream.CopyTo(Stream.Null);
            return true;
        }
        catch (InvalidDataException)
        {
            return false;
        }
    }

    /// <summary>True where the compressed stream ends before its end mark.</summary>
    private static bool IsCut(byte[] bytes)
    {
        try
        {
            using GZipStream zip = new(new MemoryStream(bytes), CompressionMode.Decompress);
            using CountedStream counted = new(zip, Limits.Unpacked);
            counted.CopyTo(Stream.Null);
            return false;
        }
        catch (InvalidDataException broken)
        {
            return broken.Message.Contains("truncated", StringComparison.OrdinalIgnoreCase);
        }
        catch (TooLargeException)
        {
            return false;
        }
    }

    private static bool IsFile(TarEntry entry) => entry.EntryType is TarEntryType.RegularFile or TarEntryType.V7RegularFile or TarEntryType.ContiguousFile;

    private static string Clean(string name) => name.StartsWith("./", StringComparison.Ordinal) ? name[2..] : name;

    private sealed class TooManyException : Exception;
}
