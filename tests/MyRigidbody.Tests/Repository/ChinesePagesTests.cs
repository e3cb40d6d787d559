using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Languages;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>A Chinese page contains no English sentence, and none of its links leads to an English page.</summary>
public sealed partial class ChinesePagesTests
{
    private const string Chinese = ".zh.md";

    // both languages side by side; and what only those who work on the program open
    private static readonly string[] Allowed = ["docs/terms.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"];

    private static readonly string[] Pages = [.. Tree.Files(".", "*" + Chinese).Select(page => page.StartsWith("./", StringComparison.Ordinal) ? page[2..] : page)];

    [TestCaseSource(nameof(Pages))]
    public void No_sentence_is_in_English(string page)
    {
        string text = Link().Replace(Picture().Replace(InlineCode().Replace(CodeBlock().Replace(Tree.Text(page), string.Empty), "…"), "$1"), "$1");

        Assert.That(text, Does.Match(@"\p{IsCJKUnifiedIdeographs}"));
        Assert.That(EnglishSentences.In(Title().Replace(text, "…")), Is.Empty);
    }

    [TestCaseSource(nameof(Pages))]
    public void No_link_leads_to_an_English_page(string page)
    {
        string folder = Path.GetDirectoryName(page)!, own = Path.GetFileName(page).Replace(Chinese, ".md", StringComparison.Ordinal);
        string[] english = [.. Target().Matches(Tree.Text(page)).Select(match => match.Groups[1].Value)
            .Where(target => target.EndsWith(".md", StringComparison.Ordinal) && !target.EndsWith(Chinese, StringComparison.Ordinal) && target != own)
            .Select(target => Path.GetRelativePath(Root.Path, Path.Combine(Root.Path, folder, target)).Replace('\\', '/'))];

        Assert.That(english.Except(Allowed), Is.Empty);
    }

    // menus and the titles of Unity's pages are what the reader finds there
    [GeneratedRegex(@"\*{1,2}[^*\n]+\*{1,2}")]
    private static partial Regex Title();

    [GeneratedRegex(@"^```.*?^```|^    .*?$", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex CodeBlock();

    [GeneratedRegex("`[^`]*`")]
    private static partial Regex InlineCode();

    [GeneratedRegex(@"!\[([^\]]*)\]\([^)]*\)")]
    private static partial Regex Picture();

    [GeneratedRegex(@"\[([^\]]*)\]\([^)]*\)")]
    private static partial Regex Link();

    [GeneratedRegex(@"\]\(([^)#:]+)(#[^)]*)?\)")]
    private static partial Regex Target();
}
