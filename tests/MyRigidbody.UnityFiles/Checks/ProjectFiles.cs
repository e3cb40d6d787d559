namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>
/// The Unity project as texts by their paths from the root of the repository, with forward slashes, and with it the package
/// that it takes from there. Changed copies stand in memory.
/// </summary>
public sealed class ProjectFiles
{
    /// <summary>The folder of the project.</summary>
    public const string Project = "UnityProject";

    /// <summary>What is imported from <see cref="Project"/>.</summary>
    public const string Assets = Project + "/Assets";

    /// <summary>A package that the project takes from the repository: the library.</summary>
    public const string Package = "MyRigidbody.Core";

    /// <summary>Another one: the judge of students' scripts.</summary>
    public const string Judge = "MyRigidbody.Judge";

    private static readonly string[] Folders = [Assets, Project + "/Packages", Project + "/ProjectSettings", Package, Judge];

    private readonly SortedDictionary<string, string> _texts;

    private ProjectFiles(IDictionary<string, string> texts) => _texts = new SortedDictionary<string, string>(texts, StringComparer.Ordinal);

    /// <summary>All texts by their paths.</summary>
    public IReadOnlyDictionary<string, string> Texts => _texts;

    /// <summary>Reads the project below a root.</summary>
    public static ProjectFiles Read(string root) => new(Folders
        .SelectMany(folder => Directory.EnumerateFiles(Path.Combine(root, folder), "*", SearchOption.AllDirectories))
        .ToDictionary(file => Path.GetRelativePath(root, file).Replace('\\', '/'), File.ReadAllText));

    /// <summary>The same with one file more, or another text in it.</summary>
    public ProjectFiles With(string path, string text) => new(new Dictionary<string, string>(_texts) { [path] = text });

    /// <summary>The same without a file.</summary>
    public ProjectFiles Without(string path)
    {
        Dictionary<string, string> others = new(_texts);
        return others.Remove(path) ? new ProjectFiles(others) : throw new ArgumentException($"no {path}", nameof(path));
    }

    /// <summary>What Unity imports from a folder, files and folders; not what is hidden, ends in ~ or is a *.tmp, nor the metas.</summary>
    public IReadOnlySet<string> ImportedFrom(string folder)
    {
        SortedSet<string> imported = new(StringComparer.Ordinal);
        foreach (string path in _texts.Keys.Where(path => path.StartsWith(folder + "/", StringComparison.Ordinal) && !IsMeta(path)))
        {
            string[] parts = path[(folder.Length + 1)..].Split('/');
            if (parts.Any(IsHidden))
                continue;

            for (int i = 1; i <= parts.Length; i++)
                imported.Add(folder + "/" + string.Join('/', parts[..i]));
        }

        return imported;
    }

    public static bool IsMeta(string path) => path.EndsWith(".meta", StringComparison.Ordinal);

    private static bool IsHidden(string name) =>
        name.StartsWith('.') || name.EndsWith('~') || name.EndsWith(".tmp", StringComparison.Ordinal) || name.Equals("cvs", StringComparison.OrdinalIgnoreCase);
}
