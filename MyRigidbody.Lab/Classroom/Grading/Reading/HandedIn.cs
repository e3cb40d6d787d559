using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>Everything that the paths of a command line hold.</summary>
/// <param name="Pieces">Scripts, packages and what could not be read, by their places.</param>
/// <param name="Notes">What was passed over, with its place.</param>
internal sealed record HandedIn(IReadOnlyList<Piece> Pieces, IReadOnlyList<(string Place, Finding Finding)> Notes)
{
    /// <summary>Reads files and folders.</summary>
    /// <param name="paths">As they were typed.</param>
    /// <param name="own">The folder that is written to; nothing in it was handed in.</param>
    public static HandedIn Read(IReadOnlyList<string> paths, string own)
    {
        Walk walk = new(Path.GetFullPath(own));
        foreach ((string path, Spot spot) in paths.Zip(Roots(paths)))
        {
            if (Directory.Exists(path))
                walk.Folder(new DirectoryInfo(path), spot);
            else
                walk.Given(path, spot);
        }

        return new HandedIn([.. walk.Pieces.OrderBy(piece => piece.Spot.Shown, StringComparer.Ordinal)], walk.Notes);
    }

    /// <summary>How each path is shown: by its last names, as many as tell it from the others, however it was typed.</summary>
    private static List<Spot> Roots(IReadOnlyList<string> paths)
    {
        string[][] full = [.. paths.Select(path => Path.GetFullPath(path).Split([Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar], StringSplitOptions.RemoveEmptyEntries))];
        return [.. full.Zip(paths, (names, path) =>
        {
            // who hands over single files names the student by the folder of each
            int own = File.Exists(path) ? 2 : 1, shown = own;
            while (shown < names.Length && full.Any(other => !other.SequenceEqual(names) && other.TakeLast(shown).SequenceEqual(names.TakeLast(shown))))
                shown++;

            return new Spot(string.Join('/', names.TakeLast(shown)), [.. names.TakeLast(own)]);
        })];
    }

    private sealed class Walk(string own)
    {
        private int _files;

        public List<Piece> Pieces { get; } = [];

        public List<(string Place, Finding Finding)> Notes { get; } = [];

        public void Folder(DirectoryInfo folder, Spot spot)
        {
            if (Path.TrimEndingDirectorySeparator(folder.FullName) == Path.TrimEndingDirectorySeparator(own))
                return;

            foreach (FileSystemInfo entry in Entries(folder, spot))
            {
                Spot inside = spot.InFolder(entry.Name);
                if (entry.LinkTarget != null || entry.Attributes.HasFlag(FileAttributes.ReparsePoint))
                    Notes.Add((inside.Shown, Problems.Link(entry.Name)));
                else if (entry is DirectoryInfo below)
                    Below(below, inside);
                else if (FileKinds.MayHoldScripts(entry.Name) && RealPath.IsPlainFile(entry.FullName))
                    OfFolder((FileInfo)entry, inside);
            }
        }

        /// <summary>A file named on the command line: it must be there, and must be something.</summary>
        public void Given(string path, Spot spot)
        {
            IReadOnlyList<Piece> pieces = Reader.Read(spot, [.. InputFile.Bytes(path)]);
            Pieces.AddRange(pieces.Count > 0 ? pieces : throw new InputException($"{path}: is no script (.cs), no .unitypackage and no .zip"));
        }

        private void Below(DirectoryInfo folder, Spot spot)
        {
            // what Unity and IDEs make for themselves
            if (folder.Name is not ("Library" or "Temp" or "obj" or "Logs" or "__MACOSX" or ".git" or ".vs"))
                Folder(folder, spot);
        }

        private void OfFolder(FileInfo file, Spot spot)
        {
            if (++_files > Limits.Entries)
                throw new InputException($"{spot.Shown}: the folder has more than {Limits.Entries} scripts and archives");

            try
            {
                if (file.Length > Limits.Archive)
                    Pieces.Add(Piece.Unreadable(spot, Problems.TooLarge(Limits.Archive)));
                else
                    Pieces.AddRange(Reader.Read(spot, File.ReadAllBytes(file.FullName)));
            }
            catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
            {
                Pieces.Add(Piece.Unreadable(spot, Problems.Damaged(closed.Message.Replace(file.FullName, file.Name, StringComparison.Ordinal))));
            }
        }

        private IEnumerable<FileSystemInfo> Entries(DirectoryInfo folder, Spot spot)
        {
            try
            {
                return [.. folder.EnumerateFileSystemInfos().OrderBy(entry => entry.Name, StringComparer.Ordinal)];
            }
            catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
            {
                Notes.Add((spot.Shown, Problems.Damaged(closed.Message.Replace(folder.FullName, folder.Name, StringComparison.Ordinal))));
                return [];
            }
        }
    }
}
