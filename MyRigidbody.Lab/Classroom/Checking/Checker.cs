using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>Checks scripts one after another with one running process.</summary>
internal sealed class Checker : IDisposable
{
    private const int MostNeighbours = 30, LargestNeighbour = 100_000;

    private readonly ScriptRunner _runner = new();

    /// <summary>Checks a script, with the files beside it that it may use.</summary>
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

    // unreadable files beside it (an editor's lock file, say, which is a dangling link) are left out
    private static IEnumerable<ScriptFile> Neighbours(string path)
    {
        try
        {
            string own = Path.GetFullPath(path);
            return [.. new DirectoryInfo(Path.GetDirectoryName(own)!).GetFiles("*.cs")
                .Where(file => file.FullName != own && RealPath.IsPlainFile(file.FullName) && file.Length < LargestNeighbour)
                .OrderBy(file => file.Name, StringComparer.Ordinal)
                .Take(MostNeighbours)
                .Select(Read)
                .OfType<ScriptFile>()];
        }
        catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    // other scripts of the same name are those of other students
    private static ScriptFile? Read(FileInfo file)
    {
        try
        {
            ScriptFile read = new(file.Name, InputFile.Bytes(file.FullName).ToArray());
            return SourceText.Decode(read.Bytes).Text.Contains("class MyRigidbody", StringComparison.OrdinalIgnoreCase) ? null : read;
        }
        catch (InputException)
        {
            return null;
        }
    }
}
