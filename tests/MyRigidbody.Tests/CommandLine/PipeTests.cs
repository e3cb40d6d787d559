using System.Diagnostics;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>The command line in a shell: a reader that closes the pipe, a name that begins with @.</summary>
public sealed class PipeTests
{
    [Test]
    [Platform(Exclude = "Win")]
    public void A_reader_that_leaves_ends_the_run_and_is_no_error()
    {
        using TemporaryFolder folder = new();
        using Process shell = Process.Start(new ProcessStartInfo("bash")
        {
            // a run of hours
            ArgumentList = { "-c", "dotnet \"$0\" run \"$1\" --step 1e-9 | head -n 2; echo ${PIPESTATUS[0]}", Path.Combine(AppContext.BaseDirectory, "MyRigidbody.Lab.dll"), Gallery.Lab },
            WorkingDirectory = folder.Path,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        })!;

        string[] lines = shell.StandardOutput.ReadToEnd().Split('\n');

        Assert.That(lines[0], Does.StartWith("body,step,t,"));
        Assert.That(lines[1], Does.StartWith("MyRigidbody,0,0,"));
        Assert.That(lines[2], Is.EqualTo("0"));
        Assert.That(shell.StandardError.ReadToEnd(), Is.Empty);
    }

    [Test]
    public void A_name_that_begins_with_an_at_sign_is_a_name()
    {
        using TemporaryFolder folder = new();
        File.Copy(Path.Combine(Gallery.Folder, "tumbling-slab.json"), folder.File("@scene.json"));
        File.WriteAllText(folder.File("@options"), "--every 0");

        LabProcess scene = LabProcess.Run(folder.Path, "run", "@scene.json", "--every", "0");
        LabProcess options = LabProcess.Run(folder.Path, "run", "@scene.json", "@options");

        Assert.That((scene.ExitCode, scene.Error), Is.EqualTo((0, string.Empty)));
        Assert.That((options.ExitCode, options.Output), Is.EqualTo((2, string.Empty)));
    }
}
