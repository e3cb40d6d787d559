using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>The place of a file: as displayed, and as the names on its path, which may name the student.</summary>
/// <param name="Shown">With <c>/</c> between folders and <c>!</c> between an archive and its content.</param>
/// <param name="Names">Names of folders, archives and the file, outermost first.</param>
internal sealed record Spot(string Shown, IReadOnlyList<string> Names)
{
    /// <summary>The name of the file or folder itself.</summary>
    public string Name => Names[^1];

    /// <summary>A file or folder in this folder.</summary>
    public Spot InFolder(string name) => new(Shown.Length == 0 ? name : $"{Shown}/{name}", [.. Names, name]);

    /// <summary>The place of a path in this archive; the path is only a name, and never followed.</summary>
    public Spot InArchive(string path)
    {
        string[] parts = [.. path.Split('/', '\\').Where(part => part.Length > 0 && part is not ("." or ".."))];
        return parts.Length == 0 ? new($"{Shown}!{path}", [.. Names, path]) : new($"{Shown}!{string.Join('/', parts)}", [.. Names, .. parts]);
    }
}

/// <summary>A file that holds C#.</summary>
/// <param name="Spot">Where it was found.</param>
/// <param name="Bytes">Its content, in whatever encoding.</param>
internal sealed record Script(Spot Spot, byte[] Bytes);

/// <summary>The content of one file: a loose script, or a package with its scripts, or the reason why it cannot be read.</summary>
/// <param name="Spot">Its place.</param>
/// <param name="IsPackage">True for a file that is one submission.</param>
/// <param name="Scripts">The scripts in it.</param>
/// <param name="Problem">Why it could not be read; null if it was.</param>
/// <param name="Notes">Problems that did not prevent reading.</param>
internal sealed record Piece(Spot Spot, bool IsPackage, IReadOnlyList<Script> Scripts, Finding? Problem, IReadOnlyList<Finding> Notes)
{
    /// <summary>A script by itself.</summary>
    public static Piece Loose(Script script) => new(script.Spot, false, [script], null, []);

    /// <summary>A file that cannot be read.</summary>
    public static Piece Unreadable(Spot spot, Finding problem) => new(spot, true, [], problem, []);
}
