using System.Diagnostics;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>The command that a page prints, pasted into a shell.</summary>
public sealed class ShellTests
{
    private static readonly string[] Hostile =
    [
        "$(touch pwned)", "`touch pwned`", "a;touch pwned", "a&touch pwned", "a|touch pwned", "a>pwned", "a\ntouch pwned\n", "'; touch pwned; '", "\"; touch pwned; \"",
        "\\\"; touch pwned; \\\"", "it's $(touch pwned)", "$HOME", "~", "*", "a?", "[a]", "{a,b}", "#a", "!!", "a b", "", "\u202e$(touch pwned)", "’; touch pwned; ’ $", "%PATH%",
        "a\\", "$\"a\\\"", "-rf", "刚体 1.json",
    ];

    [TestCase("lab.json", "lab.json")]
    [TestCase("a b.json", "\"a b.json\"")]
    [TestCase("../课/x.json", "../课/x.json")]
    [TestCase("a;b", "\"a;b\"")]
    [TestCase("it's.json", "\"it's.json\"")]
    [TestCase("a$b", "'a$b'")]
    [TestCase("$(x) 'y'", "FILE")]
    // in PowerShell round quotes are quotes
    [TestCase("a’;b", "\"a’;b\"")]
    [TestCase("a’$b", "FILE")]
    // cmd knows no single quotes
    [TestCase("a$b&c", "FILE")]
    [TestCase("a\nb", "FILE")]
    [TestCase("a\u202eb", "FILE")]
    [TestCase("", "\"\"")]
    public void Arguments_are_quoted_so_that_every_shell_reads_them_alike(string argument, string shown) =>
        Assert.That(Shell.Line("run", argument), Is.EqualTo("run " + shown));

    [TestCase("/somewhere/-rf", "./-rf")]
    [TestCase("-rf", "./-rf")]
    [TestCase("/somewhere/a.json", "a.json")]
    [Platform(Exclude = "Win")]
    public void A_file_is_shown_without_folders_of_the_machine_and_is_no_option(string path, string shown) => Assert.That(Page.Shown(path), Is.EqualTo(shown));

    [TestCaseSource(nameof(Hostile))]
    [Platform(Exclude = "Win")]
    public void Bash_gets_the_name_and_does_nothing_else(string name)
    {
        using CommandLine.TemporaryFolder folder = new();
        ProcessStartInfo start = new("bash") { WorkingDirectory = folder.Path, RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add("printf '%s\\n' " + Shell.Line(name));

        using Process bash = Process.Start(start)!;
        string printed = bash.StandardOutput.ReadToEnd();

        Assert.That(Directory.EnumerateFileSystemEntries(folder.Path), Is.Empty);
        Assert.That(printed, Is.AnyOf(name + "\n", Shell.Unquotable + "\n"));
    }
}
