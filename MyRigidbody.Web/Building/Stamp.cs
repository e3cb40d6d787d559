using System.Security.Cryptography;
using System.Text;

namespace RigidBodyDynamics.Web.Building;

/// <summary>Stores what a step of the build was made from, so that it is repeated only after a change.</summary>
/// <param name="project">The project with the stamps.</param>
/// <param name="name">The step.</param>
internal sealed class Stamp(Project project, string name)
{
    // folders of build output
    private static readonly string[] Written = ["bin", "obj", "artifacts", "node_modules", ".git"];

    private readonly string _file = Path.Combine(project.Work, name + ".stamp");

    /// <summary>Does the step if a file or a folder that it reads has changed since, or if its output is missing.</summary>
    /// <param name="inputs">Files and folders.</param>
    /// <param name="output">A file or folder that it wrote.</param>
    /// <param name="step">The step.</param>
    public void Do(IEnumerable<string> inputs, string output, Action step)
    {
        string now = Of(inputs);
        if ((File.Exists(output) || Directory.Exists(output)) && File.Exists(_file) && File.ReadAllText(_file) == now)
            return;

        Directory.CreateDirectory(project.Work);
        File.Delete(_file);
        step();
        File.WriteAllText(_file, now);
    }

    // names, lengths and times of change, so that contents need not be read
    private static string Of(IEnumerable<string> inputs)
    {
        StringBuilder list = new();
        foreach (string input in inputs)
        {
            foreach (FileInfo file in Files(input).OrderBy(file => file.FullName, StringComparer.Ordinal))
                list.Append(file.FullName).Append('|').Append(file.Length).Append('|').Append(file.LastWriteTimeUtc.Ticks).Append('\n');
        }

        return Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(list.ToString())));
    }

    private static IEnumerable<FileInfo> Files(string input) => File.Exists(input)
        ? [new FileInfo(input)]
        : new DirectoryInfo(input).EnumerateFileSystemInfos().Where(entry => !Written.Contains(entry.Name)).SelectMany(entry =>
            entry is FileInfo file ? [file] : Files(entry.FullName));
}
