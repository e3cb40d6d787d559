namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The files of the repository, without what builds and programs leave in it.</summary>
internal static class Tree
{
    private static readonly string[] NotOurs = ["artifacts", "out", "bin", "obj", ".git", ".vs", ".idea", "TestResults", "node_modules"];

    /// <summary>Files below a folder, by their path from the root, with forward slashes.</summary>
    public static string[] Files(string folder, string pattern)
    {
        string[] files = [.. Directory.EnumerateFiles(Root.File(folder), pattern, SearchOption.AllDirectories)
            .Select(FromRoot)
            .Where(path => !path.Split('/').Intersect(NotOurs).Any())
            .Order(StringComparer.Ordinal)];
        return files.Length > 0 ? files : throw new FileNotFoundException($"no {pattern} in {folder}");
    }

    /// <summary>All folders below a folder, by their path from the root.</summary>
    public static IEnumerable<string> Folders(string folder) =>
        Directory.EnumerateDirectories(Root.File(folder), "*", SearchOption.AllDirectories).Select(FromRoot);

    /// <summary>The text of a file.</summary>
    public static string Text(string path) => File.ReadAllText(Root.File(path));

    private static string FromRoot(string path) => Path.GetRelativePath(Root.Path, path).Replace('\\', '/');
}
