using System.IO.Compression;
using System.Text;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>Reads one file in memory: a script, a package, or a zip that contains them.</summary>
internal sealed class Reader
{
    private const int UnixTypeShift = 16, UnixType = 0xf000, UnixLink = 0xa000;

    private readonly List<Piece> _pieces = [];
    private long _nested;

    /// <summary>The contents of a submitted file.</summary>
    public static IReadOnlyList<Piece> Read(Spot spot, byte[] bytes)
    {
        Reader reader = new();
        reader.Look(spot, bytes, 0);
        return reader._pieces;
    }

    private void Look(Spot spot, byte[] bytes, int depth)
    {
        FileKind kind = FileKinds.Of(bytes);
        bool namedScript = FileKinds.IsScript(spot.Name);
        switch (kind)
        {
            case FileKind.Gzip or FileKind.Tar:
                _pieces.Add(TarScripts.Read(spot, bytes, [.. Ending(spot, kind), .. kind == FileKind.Tar && IsPackage(spot) ? [Problems.NotZipped()] : Array.Empty<Finding>()]));
                break;
            case FileKind.Zip when depth == Limits.Depth:
                _pieces.Add(Piece.Unreadable(spot, Problems.TooDeep()));
                break;
            case FileKind.Zip:
                Zip(spot, bytes, depth + 1);
                break;
            case FileKind.Rar or FileKind.SevenZip:
                _pieces.Add(Piece.Unreadable(spot, Problems.NotRead(kind)));
                break;
            case FileKind.Other when namedScript && bytes.Length > Limits.Script:
                _pieces.Add(Piece.Unreadable(spot, Problems.ScriptTooLarge(spot.Name)));
                break;
            case FileKind.Other when namedScript:
                _pieces.Add(Piece.Loose(new Script(spot, bytes)));
                break;
            case FileKind.Other when FileKinds.IsArchive(spot.Name):
                _pieces.Add(Piece.Unreadable(spot, bytes.Length == 0 ? Problems.Empty() : Problems.Damaged("its first bytes are those of no archive")));
                break;
        }
    }

    private void Zip(Spot spot, byte[] bytes, int depth)
    {
        // a zip with the name of a package is one submission
        bool isOne = IsPackage(spot);
        int before = _pieces.Count;
        List<Finding> notes = [.. Ending(spot, FileKind.Zip)];
        try
        {
            using ZipArchive zip = ZipNames.Open(bytes);
            if (zip.Entries.Count > Limits.Entries)
                throw new Refusal(Problems.TooManyEntries());

            Dictionary<string, string> unity = UnityPaths(zip);
            foreach (ZipArchiveEntry entry in zip.Entries.Where(entry => !entry.FullName.EndsWith('/')))
                Entry(spot, entry, unity.GetValueOrDefault(entry.FullName, entry.FullName), notes, depth);
        }
        catch (Refusal refused)
        {
            _pieces.Add(Piece.Unreadable(spot, refused.Finding));
        }
        catch (TooLargeException large)
        {
            _pieces.Add(Piece.Unreadable(spot, Problems.TooLarge(large.Limit)));
        }
        catch (Exception damaged) when (damaged is InvalidDataException or IOException or ArgumentException or NotSupportedException or OverflowException)
        {
            // the directory of a zip is at its end
            _pieces.Add(Piece.Unreadable(spot, damaged.Message.Contains("End of Central", StringComparison.OrdinalIgnoreCase) ? Problems.Truncated() : Problems.Damaged(damaged.Message)));
        }

        IReadOnlyList<Piece> inside = _pieces[before..];
        if (isOne || inside.Count == 0)
        {
            _pieces.RemoveRange(before, inside.Count);
            Finding? problem = inside.SelectMany(piece => piece.Scripts).Any() ? null : inside.Select(piece => piece.Problem).FirstOrDefault();
            _pieces.Add(new Piece(spot, true, [.. inside.SelectMany(piece => piece.Scripts)], problem, [.. notes, .. inside.SelectMany(piece => piece.Notes)]));
        }
        else
        {
            for (int i = before; i < _pieces.Count; i++)
                _pieces[i] = _pieces[i] with { Notes = [.. _pieces[i].Notes, .. notes] };
        }
    }

    private void Entry(Spot spot, ZipArchiveEntry entry, string path, List<Finding> notes, int depth)
    {
        Spot inside = spot.InArchive(path);
        if (!FileKinds.MayHoldScripts(inside.Name) || inside.Names.Contains("__MACOSX"))
            return;

        if (((entry.ExternalAttributes >> UnixTypeShift) & UnixType) == UnixLink)
        {
            notes.Add(Problems.Link(path));
            return;
        }

        if (path.Split('/', '\\').Contains("..") || path.StartsWith('/') || path.Contains(':'))
            notes.Add(Problems.PathOutside(path));

        if (entry.IsEncrypted)
            throw new Refusal(Problems.Encrypted());

        bool isScript = FileKinds.IsScript(inside.Name);
        if (isScript && entry.Length > Limits.Script)
        {
            notes.Add(Problems.ScriptTooLarge(path));
            return;
        }

        byte[] bytes;
        try
        {
            using Stream content = entry.Open();
            long left = Math.Min(Limits.Nested - _nested, isScript ? Limits.Script : Limits.Archive);
            bytes = CountedStream.ReadAll(content, left);
        }
        catch (TooLargeException large)
        {
            _pieces.Add(Piece.Unreadable(inside, Problems.TooLarge(large.Limit)));
            return;
        }

        _nested += bytes.Length;
        Look(inside, bytes, depth);
    }

    /// <summary>Paths of an unpacked Unity package that was packed again as a zip.</summary>
    private static Dictionary<string, string> UnityPaths(ZipArchive zip)
    {
        Dictionary<string, string> paths = [];
        foreach (ZipArchiveEntry entry in zip.Entries.Where(entry => entry.Name == "pathname" && !entry.IsEncrypted && entry.Length <= Limits.PathName))
        {
            using Stream content = entry.Open();
            paths[entry.FullName[..^entry.Name.Length] + "asset"] = Encoding.UTF8.GetString(CountedStream.ReadAll(content, Limits.PathName)).Split('\n')[0].Trim();
        }

        return paths;
    }

    private static IEnumerable<Finding> Ending(Spot spot, FileKind kind)
    {
        bool right = spot.Name.EndsWith(FileKinds.Ending(kind), StringComparison.OrdinalIgnoreCase)
            || (kind is FileKind.Gzip && (spot.Name.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) || spot.Name.EndsWith(".tgz", StringComparison.OrdinalIgnoreCase)))
            || (kind is FileKind.Tar && spot.Name.EndsWith(".tar", StringComparison.OrdinalIgnoreCase));
        return right ? [] : [Problems.WrongEnding(kind)];
    }

    private static bool IsPackage(Spot spot) => spot.Name.Contains(".unitypackage", StringComparison.OrdinalIgnoreCase);

    private sealed class Refusal(Finding finding) : Exception
    {
        public Finding Finding { get; } = finding;
    }
}
