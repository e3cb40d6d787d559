using System.Diagnostics;
using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Determinism;

/// <summary>Unity's editor runs on Mono, so Mono must come to the same bits.</summary>
public sealed class MonoTests
{
    // Debian's Mono keeps float in float, Unity's in double
    [TestCase("-O=float32")]
    [TestCase("-O=-float32")]
    public void Mono_comes_to_the_same_bits(string option)
    {
        string mono = OnPath("mono") ?? string.Empty;
        if (mono.Length == 0)
        {
            Assert.Ignore("there is no Mono on the PATH");
        }

        ProcessStartInfo start = new(mono, [option, Program()]) { RedirectStandardOutput = true };
        using Process process = Process.Start(start)!;
        string printed = process.StandardOutput.ReadToEnd().Trim();
        process.WaitForExit();

        Assert.That(process.ExitCode, Is.Zero);
        Assert.That(printed, Is.EqualTo(FingerprintTests.Golden.ToString("x16", CultureInfo.InvariantCulture)));
    }

    /// <summary>The net472 build, which stands beside this one: bin/PROJECT/release, bin/PROJECT/release_net472.</summary>
    private static string Program()
    {
        DirectoryInfo own = new(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory));
        return Path.Combine(
            own.Parent!.Parent!.FullName, "MyRigidbody.BitHash", own.Name + "_net472", "MyRigidbody.BitHash.exe");
    }

    private static string? OnPath(string command) =>
        (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
            .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
            .SelectMany(folder => new[] { Path.Combine(folder, command), Path.Combine(folder, command + ".exe") })
            .FirstOrDefault(File.Exists);
}
