using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The code on the pages for students is in the sources, at the line they name.</summary>
public sealed partial class UnityPageTests
{
    private const string Package = "UnityProject/Assets/MyRigidbody/", Scripts = Package + "Scripts/", Chinese = "docs/scripts.zh.md";

    [TestCase("README.md")]
    [TestCase("README.zh.md")]
    public void Every_formula_stands_in_the_line_that_the_page_names(string page)
    {
        MatchCollection rows = FormulaRow().Matches(Tree.Text(Package + page));

        Assert.That(rows, Has.Count.EqualTo(8));
        foreach (Match row in rows)
        {
            string file = Tree.Files("MyRigidbody.Core", row.Groups[2].Value).Single();
            string line = Tree.Text(file).Split('\n')[int.Parse(row.Groups[3].ValueSpan, null) - 1];
            Assert.That(line.Trim(), Is.EqualTo(row.Groups[1].Value), $"{file}, line {row.Groups[3]}");
        }
    }

    [Test]
    public void Both_languages_have_the_same_sections_tables_and_code() => Assert.That(
        Skeleton(Tree.Text(Package + "README.zh.md")), Is.EqualTo(Skeleton(Tree.Text(Package + "README.md"))));

    [Test]
    public void Code_with_Chinese_comments_is_the_code()
    {
        string sources = string.Concat(
            new[] { Scripts + "MyRigidbody.cs", Scripts + "DefaultRigidbody.cs", "MyRigidbody.Core/Integrators/LabEuler.cs" }.Select(path => Bare(Tree.Text(path))));
        MatchCollection blocks = CodeBlock().Matches(Tree.Text(Chinese));

        Assert.That(blocks, Has.Count.EqualTo(3));
        foreach (Match block in blocks)
            Assert.That(sources, Does.Contain(Bare(block.Groups[1].Value)));
    }

    // without comments, indentation and empty lines
    private static string Bare(string code) => string.Concat(code.Split('\n')
        .Select(line => line.Trim())
        .Where(line => line.Length > 0 && !line.StartsWith("//", StringComparison.Ordinal))
        .Select(line => line + "\n"));

    private static string[] Skeleton(string page) => [.. page.Split('\n')
        .Where(line => line.StartsWith('#') || line.StartsWith('|'))
        .Select(line => line.StartsWith('#') ? line.Split(' ')[0] : $"{line.Count(c => c == '|')} {FormulaRow().Match(line).Value}")];

    [GeneratedRegex(@"`([^`]+)` \| (\w+\.cs) (\d+) \|")]
    private static partial Regex FormulaRow();

    [GeneratedRegex(@"^```csharp\n(.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex CodeBlock();
}
