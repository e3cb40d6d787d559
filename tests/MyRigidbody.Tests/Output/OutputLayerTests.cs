using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Output;

/// <summary>Names in a scene cannot control the terminal on which a command prints.</summary>
public sealed partial class OutputLayerTests
{
    private const string Scene = """
        { "schema": "rigid-body-scene/1", "name": "n\u001b[31m\nerror: forged", "about": "a\u202eb\u0007", "step": 0.1, "steps": 5, "bodies": [
          { "name": "=1+1\u001b]0;x\u0007\nerror: forged \u202e", "integrator": "LabEuler" }, { "name": "b\u009b31m\r\u2028c", "integrator": "LabEuler" } ] }
        """;

    // what takes times, and with that seconds
    private static readonly object[][] Measuring = Search.In<object[]>(
        [["choose", new[] { "--error", "1e-300" }], ["choose", new[] { "--error", "1" }], ["cost", new[] { "--quick" }], ["choose", new[] { "--error", "1", "--json" }]], 2);

    [TestCase("explain")]
    [TestCase("explain", "--json")]
    [TestCase("compare")]
    [TestCase("run")]
    [TestCase("run", "--every", "0", "--report", "page.html")]
    [TestCaseSource(nameof(Measuring))]
    public void Names_send_nothing_to_the_terminal_and_forge_no_line(string command, params string[] options)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("scene.json"), Scene);

        LabProcess lab = LabProcess.Run(folder.Path, [command, "scene.json", .. options]);

        Assert.That(lab.ExitCode, Is.LessThan(2), lab.Error);
        Harmless(lab.Output);
        Harmless(lab.Error);
        Assert.That(lab.Output, Does.Contain(@"\u001b").IgnoreCase.And.Contain("error: forged"));
        foreach (string file in Directory.EnumerateFiles(folder.Path, "*", SearchOption.AllDirectories).Where(file => Path.GetExtension(file) is ".csv" or ".json" && Path.GetFileName(file) != "scene.json"))
            Harmless(File.ReadAllText(file));

        foreach (string picture in Directory.EnumerateFiles(folder.Path, "*.svg", SearchOption.AllDirectories))
            Assert.That(() => System.Xml.Linq.XDocument.Load(picture), Throws.Nothing, picture);
    }

    [TestCase("run", "\u001b[31m\nerror: forged.json")]
    [TestCase("run\nerror: forged\u001b")]
    [TestCase("run", "scene.json", "--integrator", "Exact\u001b\nerror: forged")]
    [TestCase("run", "scene.json", "--step", "1\u001b\nerror: forged")]
    [TestCase("run", "scene.json", "--out", "\0/\u001b\nerror: forged/x")]
    [TestCase("pack", "--list", "\u202e\nerror: forged")]
    public void A_mistake_with_such_a_name_is_one_line(params string[] arguments)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("scene.json"), Scene);

        LabProcess lab = LabProcess.Run(folder.Path, [.. arguments.Select(argument => argument.Replace("\0", "scene.json"))]);

        Assert.That((lab.ExitCode, lab.Error.Count(letter => letter == '\n')), Is.EqualTo((2, 1)), lab.Error);
        Harmless(lab.Error.TrimEnd());
    }

    [Test]
    public void An_integrator_that_diverges_for_such_a_body_says_so_in_one_line()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("away.json"), """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 2000, "bodies": [ { "name": "a\nerror: forged\u001b", "integrator": "LabEuler",
              "position": [1, 0, 0], "effects": [ { "spring": { "anchor": [0, 0, 0], "at": [0, 0, 0], "stiffness": 1e6 } } ] } ] }
            """);

        LabProcess lab = LabProcess.Run(folder.Path, "run", "away.json", "--every", "0");

        Assert.That((lab.ExitCode > 0, lab.Error.Count(letter => letter == '\n')), Is.EqualTo((true, 1)), lab.Error);
        Harmless(lab.Error.TrimEnd());
    }

    [Test]
    public void Nothing_of_the_program_writes_beside_the_layer()
    {
        string[] files = [.. Tree.Files("MyRigidbody.Lab", "*.cs").Where(path => !path.StartsWith("MyRigidbody.Lab/Output/", StringComparison.Ordinal))];

        Assert.That(files.SelectMany(path => Writing().Matches(File.ReadAllText(Root.File(path))).Select(match => (path, match.Value))), Is.Empty);
    }

    private static void Harmless(string text)
    {
        Assert.That(text.Where(letter => letter != '\n' && (char.IsControl(letter) || char.GetUnicodeCategory(letter) == System.Globalization.UnicodeCategory.Format)), Is.Empty);
        Assert.That(text.Split('\n').Skip(1), Has.None.StartsWith("error"));
    }

    [GeneratedRegex(@"\bConsole\.(Out|Error|Write\w*|OpenStandard\w+)\b|Spectre\.Console|\bAnsiConsole\b")]
    private static partial Regex Writing();
}
