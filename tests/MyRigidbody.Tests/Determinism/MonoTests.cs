using System.Diagnostics;
using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Bench;

namespace RigidBodyDynamics.Tests;

/// <summary>Unity's editor runs on Mono, so Mono must come to the same bits, and its times are of interest.</summary>
public sealed class MonoTests
{
    // Debian's Mono keeps float in float, Unity's in double
    [TestCase("-O=float32")]
    [TestCase("-O=-float32")]
    public void Mono_comes_to_the_same_bits(string option)
    {
        ProcessStartInfo start = new(MonoOrSkip(), [option, Program()]) { RedirectStandardOutput = true };
        using Process process = Process.Start(start)!;
        string printed = process.StandardOutput.ReadToEnd().Trim();
        process.WaitForExit();

        Assert.That(process.ExitCode, Is.Zero);
        Assert.That(printed, Is.EqualTo(FingerprintTests.Golden.ToString("x16", CultureInfo.InvariantCulture)));
    }

    [Test]
    public void Bench_times_on_Mono_what_it_times_on_CoreCLR()
    {
        MonoOrSkip();

        OnMono found = OnMono.Take(1, _ => { });

        Assert.That(found.Problem, Is.Empty);
        Assert.That(found.Times.Select(row => row.What).Where(what => !what.EndsWith("by hand", StringComparison.Ordinal)),
            Is.EqualTo(Suite.ByRule().Append(Suite.ByHand()[1]).Select(measurement => measurement.What)));
        Assert.That(found.Times.Count(row => row.What.EndsWith("by hand", StringComparison.Ordinal)), Is.EqualTo(2), "the free body and the lab's step");
        Assert.That(found.Times.SelectMany(row => new[] { row.CoreClr, row.Mono }), Is.All.GreaterThan(0));
    }

    /// <summary>The net472 build, which stands beside this one: bin/PROJECT/release, bin/PROJECT/release_net472.</summary>
    private static string Program()
    {
        DirectoryInfo own = new(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory));
        return Path.Combine(
            own.Parent!.Parent!.FullName, "MyRigidbody.BitHash", own.Name + "_net472", "MyRigidbody.BitHash.exe");
    }

    private static string MonoOrSkip()
    {
        if (OtherProgram.OnPath("mono") is string mono)
            return mono;

        Assert.Ignore("there is no Mono on the PATH");
        return string.Empty;
    }
}
