using System.Diagnostics;
using System.Text;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>The command line as a user runs it: another process, its output, its exit code.</summary>
internal sealed record LabProcess(int ExitCode, string Output, string Error)
{
    /// <summary>Runs it in a folder.</summary>
    public static LabProcess Run(string folder, params string[] arguments) => Run(folder, [], arguments);

    /// <summary>Runs it in a folder, with variables of the environment.</summary>
    public static LabProcess Run(string folder, Dictionary<string, string> environment, string[] arguments)
    {
        ProcessStartInfo start = new("dotnet")
        {
            WorkingDirectory = folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            RedirectStandardInput = true,
            StandardOutputEncoding = Encoding.UTF8,
            StandardErrorEncoding = Encoding.UTF8,
        };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "MyRigidbody.Lab.dll"));
        foreach (string argument in arguments)
            start.ArgumentList.Add(argument);

        // the locale of the machine may be Chinese
        start.Environment["LC_ALL"] = "C";
        foreach ((string name, string value) in environment)
            start.Environment[name] = value;

        using Process process = Process.Start(start)!;
        process.StandardInput.Close();
        Task<string> error = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return new LabProcess(process.ExitCode, output, error.Result);
    }
}

/// <summary>A folder that is gone after the test.</summary>
internal sealed class TemporaryFolder : IDisposable
{
    /// <summary>A new folder whose name has spaces and Chinese characters.</summary>
    public TemporaryFolder()
    {
        Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "刚体 lab " + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(Path);
    }

    /// <summary>Where it is.</summary>
    public string Path { get; }

    public string File(string name) => System.IO.Path.Combine(Path, name);

    /// <inheritdoc/>
    public void Dispose() => Directory.Delete(Path, recursive: true);
}
