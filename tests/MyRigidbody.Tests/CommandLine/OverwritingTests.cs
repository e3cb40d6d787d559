using System.Diagnostics;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>No command overwrites its input, nor replaces anything but a plain file.</summary>
public sealed class OverwritingTests
{
    private const string Short = """{ "schema": "rigid-body-scene/1", "name": "s", "step": 0.1, "steps": 2, "bodies": [ { "name": "a", "integrator": "LabEuler" } ] }""";

    [TestCase("run", "s.json", "--out", "s.json")]
    [TestCase("run", "s.json", "--out", "./s.json")]
    [TestCase("run", "s.json", "--report", "s.json")]
    [TestCase("run", "s.json", "--out", "x.html", "--report", "x.html")]
    [TestCase("run", "s.json", "--out", "x.html", "--report", "./sub/../x.html")]
    [TestCase("compare", "summary.json", "--out", ".")]
    [TestCase("run", "r/r.json", "--out", "r/r.csv")]
    [TestCase("compare", "r/r.json", "--out", "r")]
    [TestCase("compare", "r/r.json", "--out", "sub/../r/")]
    public void An_output_that_is_an_input_is_refused_and_nothing_changes(params string[] arguments)
    {
        using TemporaryFolder folder = Files();
        string before = Content(folder);

        LabProcess lab = LabProcess.Run(folder.Path, arguments);

        Assert.That((lab.ExitCode, lab.Error.Count(letter => letter == '\n')), Is.EqualTo((2, 1)), lab.Error);
        Assert.That(Content(folder), Is.EqualTo(before));
    }

    [TestCase("run", "s.json", "--out", "linked/s.json")]
    [TestCase("run", "linked/s.json", "--out", "s.json")]
    [TestCase("run", "to-s.json", "--out", "s.json")]
    [TestCase("run", "s.json", "--out", "to-s.json")]
    [TestCase("run", "s.json", "--out", "to-old.csv")]
    [TestCase("run", "s.json", "--out", "to-nothing.csv")]
    [TestCase("run", "s.json", "--out", "loop.csv")]
    [TestCase("run", "s.json", "--out", "pipe.csv")]
    [TestCase("run", "s.json", "--report", "pipe.csv")]
    [TestCase("compare", "s.json", "--out", "with-link")]
    [TestCase("compare", "r/r.json", "--out", "linked/r")]
    [Platform(Exclude = "Win")]
    public void Links_and_pipes_lead_to_no_input_and_are_not_replaced(params string[] arguments)
    {
        using TemporaryFolder folder = Files();
        Directory.CreateSymbolicLink(folder.File("linked"), folder.Path);
        Directory.CreateDirectory(folder.File("with-link"));
        File.WriteAllText(folder.File("old.csv"), "old");
        foreach ((string link, string target) in new[] { ("to-s.json", "s.json"), ("to-old.csv", "old.csv"), ("to-nothing.csv", "nothing"), ("loop.csv", "loop.csv"), ("with-link/summary.json", "../old.csv") })
            File.CreateSymbolicLink(folder.File(link), target);

        using (Process make = Process.Start("mkfifo", [folder.File("pipe.csv")]))
        {
            make.WaitForExit();
        }

        string before = Content(folder);

        LabProcess lab = LabProcess.Run(folder.Path, arguments);

        Assert.That((lab.ExitCode, lab.Error.Count(letter => letter == '\n')), Is.EqualTo((2, 1)), lab.Error);
        Assert.That(Content(folder), Is.EqualTo(before));
    }

    [Test]
    public void Old_results_and_empty_files_are_replaced_and_a_linked_folder_is_a_folder()
    {
        using TemporaryFolder folder = Files();
        File.WriteAllText(folder.File("old.csv"), "old");
        File.WriteAllText(folder.File("empty.csv"), string.Empty);
        Directory.CreateSymbolicLink(folder.File("linked"), folder.File("r"));

        foreach (string file in new[] { "old.csv", "empty.csv", "linked/new.csv" })
        {
            LabProcess lab = LabProcess.Run(folder.Path, "run", "s.json", "--out", file);

            Assert.That((lab.ExitCode, lab.Error), Is.EqualTo((0, string.Empty)));
            Assert.That(File.ReadLines(folder.File(file)).Count(), Is.EqualTo(4));
        }
    }

    private static TemporaryFolder Files()
    {
        TemporaryFolder folder = new();
        File.WriteAllText(folder.File("s.json"), Short);
        File.WriteAllText(folder.File("summary.json"), Short);
        Directory.CreateDirectory(folder.File("r"));
        Directory.CreateDirectory(folder.File("sub"));
        File.Copy(TestData.Physx("b_torque_r.json"), folder.File("r/r.json"));
        File.Copy(TestData.Physx("b_torque_r.csv"), folder.File("r/r.csv"));
        return folder;
    }

    /// <summary>Everything in the folder: names, links, and what plain files hold.</summary>
    private static string Content(TemporaryFolder folder) => string.Join('\n', Entries(new DirectoryInfo(folder.Path)).Order(StringComparer.Ordinal));

    private static IEnumerable<string> Entries(DirectoryInfo folder) => folder.EnumerateFileSystemInfos().SelectMany(entry =>
        entry.LinkTarget is string target ? [entry.FullName + " -> " + target]
        : entry is DirectoryInfo inner ? Entries(inner).Append(entry.FullName + "/")
        : [entry.FullName + ": " + (entry.Name.StartsWith("pipe", StringComparison.Ordinal) ? "pipe" : File.ReadAllText(entry.FullName))]);
}
