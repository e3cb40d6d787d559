using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>Checks scripts one after another with one warm process.</summary>
internal sealed class Checker : IDisposable
{
    private const int MostNeighbours = 30, LargestNeighbour = 100_000;

    private readonly ScriptRunner _runner = new();

    /// <summary>Checks a script with the files beside it that it may name.</summary>
    public ScriptReport Check(string path)
    {
        ScriptFile script = new(Path.GetFileName(path), InputFile.Bytes(path).ToArray());
        try
        {
            return _runner.Run([script, .. Neighbours(path)]);
        }
        catch (InvalidOperationException problem)
        {
            throw new InputException(problem.Message);
        }
    }

    public void Dispose() => _runner.Dispose();

    // other scripts of the same name are other people's
    private static IEnumerable<ScriptFile> Neighbours(string path)
    {
        DirectoryInfo folder = new(Path.GetDirectoryName(Path.GetFullPath(path))!);
        return folder.EnumerateFiles("*.cs")
            .Where(file => file.Name != Path.GetFileName(path) && file.Length < LargestNeighbour)
            .OrderBy(file => file.Name, StringComparer.Ordinal)
            .Take(MostNeighbours)
            .Select(file => new ScriptFile(file.Name, InputFile.Bytes(file.FullName).ToArray()))
            .Where(file => !SourceText.Decode(file.Bytes).Text.Contains("class MyRigidbody", StringComparison.OrdinalIgnoreCase));
    }
}
