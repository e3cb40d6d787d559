using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Languages;

/// <summary>What is opened after a command in Chinese, pages and pictures, begins in Chinese and has no English sentence.</summary>
public sealed partial class ChinesePageTests
{
    private static readonly string[] Lab = ["compare", Path.Combine(Gallery.Folder, "lab.json"), "--out", "out"];
    private static readonly string[] Script = ["check", TestData.Path("submissions", "class", "210840364_学生五二", "MyRigidbody.cs"), "--out", "out"];

    // what keeps a script from being run has the most to say
    private static readonly string[] NotRun = ["210840560_学生八〇", "210840630_学生九〇", "210840637_学生九一", "210840672_学生九六", "210840728_学生一〇四"];

    private static readonly TestCaseData[] Pages =
    [
        new TestCaseData([Lab]).SetArgDisplayNames("compare"),
        new TestCaseData([Script]).SetArgDisplayNames("check"),
        new TestCaseData([(string[])["grade", .. NotRun.Select(student => TestData.Path("submissions", "class", student)), TestData.Path("submissions", "packages"), "--out", "out"]]).SetArgDisplayNames("grade"),
        new TestCaseData([new[] { "cost", Path.Combine(Gallery.Folder, "tumbling-slab.json"), "--quick", "--out", "out" }]).SetArgDisplayNames("cost"),
        new TestCaseData([new[] { "run", Path.Combine(Gallery.Folder, "locked-door.json"), "--every", "0", "--report", "out/report.html" }]).SetArgDisplayNames("run"),
    ];

    [TestCaseSource(nameof(Pages))]
    public void Pages_have_no_English_sentence(string[] arguments)
    {
        using TemporaryFolder folder = new();
        Directory.CreateDirectory(folder.File("out"));
        LabProcess.Run(folder.Path, [.. arguments, "--lang", "zh"]);
        string[] pages = Directory.GetFiles(folder.File("out"), "*.html", SearchOption.AllDirectories);

        Assert.That(pages, Is.Not.Empty);
        foreach (string page in pages)
        {
            string html = File.ReadAllText(page);
            Assert.That(html, Does.Contain("<html lang=\"zh\">"), page);
            Assert.That(EnglishSentences.In(Tag().Replace(English().Replace(Unseen().Replace(html, string.Empty), string.Empty), "\n")), Is.Empty, page);
        }
    }

    [Test]
    public void Pictures_are_labelled_in_Chinese_where_there_is_a_font()
    {
        using TemporaryFolder folder = new();
        LabProcess.Run(folder.Path, [.. Lab, "--lang", "zh"]);
        string[] labels = [.. Directory.GetFiles(folder.File("out"), "*.svg").SelectMany(picture => Label().Matches(File.ReadAllText(picture)).Select(match => match.Groups[1].Value.Trim()))];

        Assert.That(labels, Has.Length.GreaterThan(50));
        Assert.That(labels, PictureWords.HasChinese ? Has.Some.Contains("转动惯量").And.Some.Contains("时间").And.None.Contains("time") : Has.Some.Contains("time"));
    }

    // programs, styles, and code that is to be copied
    [GeneratedRegex(@"<(script|style|code|pre)\b.*?</\1>|<!--.*?-->", RegexOptions.Singleline)]
    private static partial Regex Unseen();

    [GeneratedRegex(@"<span lang=""en"">.*?</span>", RegexOptions.Singleline)]
    private static partial Regex English();

    [GeneratedRegex("<[^>]+>")]
    private static partial Regex Tag();

    [GeneratedRegex("<text[^>]*>([^<]*)")]
    private static partial Regex Label();
}
