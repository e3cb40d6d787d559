using System.ComponentModel;
using System.Diagnostics;
using System.Text;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>The output of another program, after it has ended.</summary>
/// <param name="Output">What it printed; empty if there is a problem.</param>
/// <param name="Problem">Why there is no output, in one line; empty if there is.</param>
internal sealed record OtherProgram(string Output, string Problem)
{
    /// <summary>Runs a program for at most a given time; then it is killed.</summary>
    public static OtherProgram Run(string program, IEnumerable<string> arguments, IReadOnlyDictionary<string, string> environment, TimeSpan patience)
    {
        ProcessStartInfo start = new(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            StandardOutputEncoding = Encoding.UTF8,
            StandardErrorEncoding = Encoding.UTF8,
        };
        foreach ((string name, string value) in environment)
            start.Environment[name] = value;

        string called = Path.GetFileNameWithoutExtension(program);
        try
        {
            using Process process = Process.Start(start)!;
            process.StandardInput.Close();
            // both are read at once: a program that fills one pipe while the other is read would wait for ever
            Task<string> output = process.StandardOutput.ReadToEndAsync(), error = process.StandardError.ReadToEndAsync();
            if (!Task.WaitAll([output, error], patience) || !process.WaitForExit(patience))
            {
                process.Kill(entireProcessTree: true);
                return Failed(FormattableString.Invariant($"{called} did not end within {patience.TotalSeconds} s"));
            }

            return process.ExitCode == 0
                ? new OtherProgram(output.Result, string.Empty)
                : Failed($"{called} ended with exit code {process.ExitCode}: {error.Result.Trim().Split('\n')[0].TrimEnd()}");
        }
        catch (Exception problem) when (problem is Win32Exception or InvalidOperationException or IOException or AggregateException)
        {
            return Failed($"{called} cannot be run: {problem.Message.ReplaceLineEndings(" ")}");
        }
    }

    /// <summary>The file of a command, as a shell would find it; null if there is none.</summary>
    public static string? OnPath(string command) => (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .SelectMany(folder => new[] { Path.Combine(folder, command), Path.Combine(folder, command + ".exe") })
        .FirstOrDefault(File.Exists);

    private static OtherProgram Failed(string problem) => new(string.Empty, problem);
}
