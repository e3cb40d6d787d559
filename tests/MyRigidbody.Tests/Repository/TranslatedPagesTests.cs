using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>A page that is there in both languages says the same in both: as many headings, the same tables, code and figures.</summary>
public sealed partial class TranslatedPagesTests
{
    private const string Chinese = ".zh.md", English = ".md";

    // the scripts of the Unity project are in English themselves
    private static readonly string[] Pages = [.. Tree.Files("docs", "*" + Chinese).Where(page => File.Exists(Root.File(InEnglish(page))))];

    // what a student or an instructor opens
    private static readonly string[] Opened = ["lab", "integrators", "effects", "accuracy", "differences", "scenes", "inertia", "exact-rotation", "first-import", "teaching", "library", "hard-cases", "stand-in", "unity-members"];

    [Test]
    public void What_students_and_instructors_open_is_there_in_Chinese() =>
        Assert.That(Pages, Is.EquivalentTo(Opened.Select(name => $"docs/{name}{Chinese}")));

    [TestCaseSource(nameof(Pages))]
    public void Headings_and_tables_are_those_of_the_other_language(string page) =>
        Assert.That(Skeleton(Tree.Text(page)), Is.EqualTo(Skeleton(Tree.Text(InEnglish(page)))));

    [TestCaseSource(nameof(Pages))]
    public void Figures_are_those_of_the_other_language(string page) =>
        Assert.That(Figures(Tree.Text(page)), Is.EqualTo(Figures(Tree.Text(InEnglish(page)))).And.Not.Empty);

    [TestCaseSource(nameof(Pages))]
    public void Code_is_that_of_the_other_language(string page) =>
        Assert.That(Code(Tree.Text(page)), Is.EqualTo(Code(Tree.Text(InEnglish(page)))));

    [TestCaseSource(nameof(Pages))]
    public void Each_language_leads_to_the_other(string page)
    {
        Assert.That(Tree.Text(page), Does.Contain($"[English]({Path.GetFileName(InEnglish(page))})"));
        Assert.That(Tree.Text(InEnglish(page)), Does.Contain($"[中文]({Path.GetFileName(page)})"));
    }

    private static string InEnglish(string page) => page.Replace(Chinese, English, StringComparison.Ordinal);

    /// <summary>The level of each heading and the number of cells of each row.</summary>
    private static string[] Skeleton(string page) => [.. CodeBlock().Replace(page, string.Empty).Split('\n')
        .Where(line => line.StartsWith('#') || line.StartsWith('|'))
        .Select(line => line.StartsWith('#') ? line.Split(' ')[0] : $"{line.Count(c => c == '|')} cells")];

    /// <summary>Numbers that are no words in a sentence: with a point, an exponent or three digits and more.</summary>
    private static string[] Figures(string page) => [.. Number().Matches(LinkTarget().Replace(page, string.Empty)).Select(match => match.Value)
        .Where(number => number.Length > 2).Distinct().Order(StringComparer.Ordinal)];

    /// <summary>Lines of C# and of the shell, without comments and texts.</summary>
    private static string[] Code(string page) => [.. CodeBlock().Matches(page).Select(match => match.Value)
        .Where(block => block.StartsWith("```csharp", StringComparison.Ordinal))
        .SelectMany(block => block.Split('\n'))
        .Select(line => Comment().Replace(line, string.Empty).TrimEnd())
        .Where(line => line.Length > 0)];

    [GeneratedRegex(@"^```.*?^```", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex CodeBlock();

    [GeneratedRegex(@"\]\([^)]*\)")]
    private static partial Regex LinkTarget();

    [GeneratedRegex(@"(?<![\w.])\d+(\.\d+)?(e[-+]?\d+)?")]
    private static partial Regex Number();

    [GeneratedRegex(@"\s*//.*$")]
    private static partial Regex Comment();
}
