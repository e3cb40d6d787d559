using System.Text.RegularExpressions;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>
/// Groups files into submissions: a package is one; loose scripts are one where they are in one folder that is named after a
/// student, or in one folder of the class, or are files named after students.
/// </summary>
internal static partial class Grouping
{
    private const string MainFile = "MyRigidbody.cs";

    /// <summary>The submissions, ordered by place.</summary>
    public static IReadOnlyList<Submission> Of(HandedIn handedIn, Roster? roster)
    {
        IEnumerable<Submission> packages = handedIn.Pieces.Where(piece => piece.IsPackage)
            .Select(piece => Named(piece.Spot, piece.Scripts, piece.Problem, piece.Notes, roster));
        HashSet<Piece> mains = [.. handedIn.Pieces.Where(piece => !piece.IsPackage && IsMain(piece.Scripts[0]))];
        IEnumerable<Submission> loose = handedIn.Pieces.Where(piece => !piece.IsPackage)
            .GroupBy(piece => Home(piece, mains))
            .Select(pieces => Named(Spot(pieces.Key, pieces.First()), [.. pieces.SelectMany(piece => piece.Scripts)], null, [.. pieces.SelectMany(piece => piece.Notes).Distinct()], roster))
            // other code is ignored, as long as there is something to grade
            .Where(submission => submission.Student != null || mains.Count == 0 || submission.Scripts.Any(IsMain));
        return [.. packages.Concat(loose).OrderBy(submission => submission.Spot.Shown, StringComparer.Ordinal)];
    }

    /// <summary>True for a script with the name that the sheet asks for, or with the class.</summary>
    public static bool IsMain(Script script) =>
        script.Spot.Name.Equals(MainFile, StringComparison.OrdinalIgnoreCase) || MainClass().IsMatch(SourceText.Decode(script.Bytes).Text);

    /// <summary>The folder names that loose scripts of one submission share.</summary>
    private static string Home(Piece piece, IReadOnlySet<Piece> mains)
    {
        IReadOnlyList<string> names = piece.Spot.Names;
        if (Named(names) is int count)
            return Key(names, count);

        // the folder below the given one; if it holds scripts of several students, then the folder of each, or each script alone
        int folder = names.Count - 1, top = Math.Min(2, folder);
        return MainsIn(Key(names, top)) <= 1 ? Key(names, top)
            : MainsIn(Key(names, folder)) <= 1 || !mains.Contains(piece) ? Key(names, folder)
            : Key(names, names.Count);

        int MainsIn(string key) => mains.Count(main => Key(main.Spot.Names, main.Spot.Names.Count).StartsWith(key + "\n", StringComparison.Ordinal));
    }

    /// <summary>The number of names to the innermost folder named after a student, or to the script named after another one.</summary>
    private static int? Named(IReadOnlyList<string> names)
    {
        IReadOnlyList<Student> own = StudentName.Read(names[^1]);
        for (int count = names.Count - 1; count > 0; count--)
        {
            IReadOnlyList<Student> folder = StudentName.Read(names[count - 1]);
            if (folder.Count > 0)
                return own.Count == 0 || folder.Any(student => student.Id == own[0].Id) ? count : names.Count;
        }

        return own.Count > 0 ? names.Count : null;
    }

    private static string Key(IReadOnlyList<string> names, int count) => string.Join('\n', names.Take(count));

    /// <summary>The place of the folder, or of a script that is alone.</summary>
    private static Spot Spot(string key, Piece first)
    {
        int drop = first.Spot.Names.Count - key.Split('\n').Length;
        string shown = first.Spot.Shown;
        for (int i = 0; i < drop; i++)
            shown = shown[..Math.Max(0, shown.LastIndexOfAny(['/', '!']))];

        return drop == 0 ? first.Spot : new Spot(shown, [.. first.Spot.Names.SkipLast(drop)]);
    }

    private static Submission Named(Spot spot, IReadOnlyList<Script> scripts, Finding? problem, IReadOnlyList<Finding> notes, Roster? roster)
    {
        // the nearest name counts; names inside a package only where none around it names a student
        IEnumerable<string> names = spot.Names.Reverse().Concat(scripts.Select(script => script.Spot.Name));
        Student[] read = [.. names.SelectMany(StudentName.Read)];
        Student? known = roster == null ? null : read.Select(roster.Find).FirstOrDefault(student => student != null);
        Student? student = known ?? read.FirstOrDefault(one => one.Name.Length > 0) ?? read.FirstOrDefault()
            ?? (roster == null ? null : spot.Names.Reverse().Select(name => roster.Named(StudentName.Stem(name))).FirstOrDefault(one => one != null));
        return new Submission(spot, student, spot.Names.Any(StudentName.IsAsAsked), scripts, problem, notes);
    }

    [GeneratedRegex(@"\bclass\s+MyRigidbody\b")]
    private static partial Regex MainClass();
}
