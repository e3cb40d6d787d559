using System.ComponentModel;
using System.Diagnostics;

namespace RigidBodyDynamics.Web.Building;

/// <summary>Runs a program of the toolchain.</summary>
internal static class Tool
{
    /// <summary>Runs it to its end; its output is shown only if it fails.</summary>
    /// <param name="folder">The working directory.</param>
    /// <param name="program">Its name on the path.</param>
    /// <param name="missing">The message if it is not installed.</param>
    /// <param name="arguments">Its arguments.</param>
    public static void Run(string folder, string program, string missing, params string[] arguments)
    {
        // npm and similar programs are shell scripts there
        bool isScript = OperatingSystem.IsWindows() && program != "dotnet";
        ProcessStartInfo start = isScript ? new("cmd.exe", ["/d", "/c", program, .. arguments]) : new(program, arguments);
        start.WorkingDirectory = folder;
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        try
        {
            using Process process = Process.Start(start)!;
            Task<string> complaints = process.StandardError.ReadToEndAsync();
            string said = process.StandardOutput.ReadToEnd() + complaints.Result;
            process.WaitForExit();
            // the answer of the Windows shell for an unknown program
            if (isScript && process.ExitCode is 1 or 9009 && said.Contains($"'{program}'", StringComparison.Ordinal))
                throw new RefusedException(missing);

            if (process.ExitCode != 0)
            {
                Console.Error.WriteLine(said.TrimEnd());
                throw new RefusedException($"{program} {arguments[0]} failed with exit code {process.ExitCode} in {folder}");
            }
        }
        catch (Win32Exception)
        {
            throw new RefusedException(missing);
        }
    }
}
