using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Inertia;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Languages;

/// <summary>In Chinese the command line prints no English sentence: not in help, tables, sentences or errors.</summary>
public sealed partial class ChineseTests
{
    private static readonly string[] Commands = ["compare", "run", "cost", "choose", "explain", "inertia", "bench", "integrators", "grade", "pack", "check"];

    private static readonly TestCaseData[] Uses =
    [
        Use("--help"),
        .. Commands.Select(command => Use(command, "--help")),
        Use("compare", Scene("lab.json"), "--out", "compared"),
        Use("compare", "missing.json"),
        Use("run", Scene("lab.json"), "--every", "often"),
        Use("run", Scene("lab.json"), "--integrator", "Euler"),
        Use("run", Scene("lab.json"), "--out", "."),
        Use("run", "--step"),
        Use("choose", Scene("lab.json"), "--error", "1e-3"),
        Use("choose", Scene("tumbling-slab.json"), "--error", "1e-15"),
        Use("explain", Scene("lab.json")),
        Use("explain", Scene("fall-with-drag.json")),
        Use("inertia", Scene("t-handle.json")),
        Use("integrators"),
        Use("grade", TestData.Path("submissions", "class", "210840364_学生五二"), "--out", "graded"),
        Use("grade", "missing"),
        Use("check", TestData.Path("submissions", "class", "210840364_学生五二", "MyRigidbody.cs"), "--out", "checked"),
        Use("pack", "--out", "package.zip"),
        Use("fly"),
        Use("check", "--lang"),
    ];

    [TestCaseSource(nameof(Uses))]
    public void Nothing_that_is_said_is_in_English(string[] arguments)
    {
        using TemporaryFolder folder = new();
        LabProcess said = LabProcess.Run(folder.Path, [.. arguments, "--lang", "zh"]);

        Assert.That(said.ExitCode, Is.LessThanOrEqualTo(2));
        Assert.That(said.Output + said.Error, Does.Match(ChineseLetter()));
        Assert.That(EnglishSentences.In(said.Output + said.Error), Is.Empty);
    }

    [Test]
    public void Every_sentence_of_the_source_is_there_in_Chinese()
    {
        (string File, string Text)[] said = [.. SaidInSource.All()];

        Assert.That(said, Has.Length.GreaterThan(400));
        Assert.That(said.Where(one => Forms(one.Text).All(text => EnglishSentences.In(Sentences.InChinese(text)).Any())).Select(one => $"{one.File}: {one.Text}").Aggregate(string.Empty, (all, one) => all + one + "\n"), Is.Empty);
    }

    [Test]
    public void What_the_library_refuses_is_said_in_Chinese()
    {
        string[] said = [.. Refusals.All().Select(refused => Assert.Catch<ArgumentException>((TestDelegate)refused.Arguments[2]!)!.Message)];

        Assert.That(said, Has.Length.GreaterThan(300));
        Assert.That(said.Select(Sentences.InChinese).SelectMany(EnglishSentences.In).Distinct(), Is.Empty);
    }

    [Test]
    public void What_is_wrong_with_robots_is_said_in_Chinese()
    {
        string[] said = [.. Directory.GetFiles(TestData.Path("robots")).SelectMany(path => InertiaFile.Read(path, null).Bodies)
            .SelectMany(body => Diagnosis.Of(body).Select(finding => finding.Text))];

        Assert.That(said, Has.Length.GreaterThan(15));
        Assert.That(said.Select(Sentences.InChinese).SelectMany(EnglishSentences.In), Is.Empty);
    }

    [Test]
    public void Every_sentence_is_known_once_and_keeps_what_is_put_into_it()
    {
        (string English, string Chinese)[] all = [.. Sentences.Read()];

        Assert.That(all, Has.Length.GreaterThan(400));
        Assert.That(all.Select(pair => pair.English), Is.Unique);
        foreach ((string english, string chinese) in all)
        {
            Assert.That(chinese, Does.Match(ChineseLetter()), english);
            Assert.That(Holes().Matches(chinese).Select(match => match.Value).Order(), Is.EqualTo(Holes().Matches(english).Select(match => match.Value).Order()), english);
        }
    }

    [Test]
    public void What_is_read_by_programs_is_the_same_in_both_languages()
    {
        using TemporaryFolder folder = new();
        foreach (string[] arguments in new[] { ["run", Scene("lab.json"), "--every", "100"], new[] { "integrators", "--json" }, ["inertia", Scene("hammer.json"), "--json"] })
        {
            LabProcess english = LabProcess.Run(folder.Path, [.. arguments, "--lang", "en"]), chinese = LabProcess.Run(folder.Path, [.. arguments, "--lang", "zh"]);

            Assert.That(chinese, Is.EqualTo(english), string.Join(' ', arguments));
        }
    }

    [TestCase("zh_CN.UTF-8", "没有这个文件")]
    [TestCase("de_DE.UTF-8", "there is no such file")]
    [Platform("Unix")]
    public void Without_an_option_the_language_is_that_of_the_system(string locale, string expected)
    {
        using TemporaryFolder folder = new();

        Assert.That(LabProcess.Run(folder.Path, new Dictionary<string, string> { ["LC_ALL"] = locale }, ["run", "missing.json"]).Error, Does.Contain("missing.json: " + expected));
    }

    private static TestCaseData Use(params string[] arguments) =>
        new TestCaseData([arguments]).SetArgDisplayNames(string.Join(' ', arguments.Select(Path.GetFileName)));

    private static string Scene(string name) => Path.Combine(Gallery.Folder, name);

    // by itself, behind "must be", and without an end that only a run knows
    private static string[] Forms(string text) => [text, "must be " + text, text[..^1]];

    [GeneratedRegex(@"\p{IsCJKUnifiedIdeographs}")]
    private static partial Regex ChineseLetter();

    [GeneratedRegex(@"\{[0-9a-z]\}")]
    private static partial Regex Holes();
}
