using System.Reflection;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Every listing of docs/library.md is compiled against what is public, run, and prints what the page says.</summary>
public sealed class LibraryPageTests
{
    private const string Page = "docs/library.md", Chinese = "docs/library.zh.md";
    private static readonly string[] Listings = ["loop", "hello", "bounce", "thousand", "saving", "effect"];

    // stands where a program of its own has System.Console, which other tests write to as well
    private const string Console = """
        global using System;
        public static class Console
        {
            public static readonly System.Text.StringBuilder Said = new();
            public static void WriteLine(object line) => Said.Append(line).Append('\n');
        }
        """;

    [TestCaseSource(nameof(Listings)), SetCulture("")]
    public void Listing_prints_what_the_page_says(string name) =>
        Assert.That(Run(PageText.Block(Page, $"<!-- {name} -->")), Is.EqualTo(PageText.Block(Page, $"<!-- {name} says -->")));

    [Test]
    public void First_listing_is_a_game_loop_of_thirty_lines_that_uses_nothing_but_the_library()
    {
        string[] first = [.. File.ReadLines(Root.File(Page)).SkipWhile(line => line != "```csharp").Skip(1).TakeWhile(line => line != "```")];
        Assert.That(first, Is.EqualTo(PageText.Block(Page, "<!-- loop -->")));
        Assert.That(first, Has.Length.LessThanOrEqualTo(30)); // measured 30
        Assert.That(first.Where(line => line.StartsWith("using ", StringComparison.Ordinal)), Is.EqualTo(new[] { "using RigidBodyDynamics;" }));
    }

    [TestCaseSource(nameof(Listings))]
    public void Page_in_Chinese_has_the_same_listings(string name)
    {
        foreach (string block in new[] { $"<!-- {name} -->", $"<!-- {name} says -->" })
            Assert.That(PageText.Block(Chinese, block), Is.EqualTo(PageText.Block(Page, block)));
    }

    private static string[] Run(string[] listing)
    {
        Assembly assembly = Outside.Program(string.Join('\n', listing), Console);
        assembly.EntryPoint!.Invoke(null, [Array.Empty<string>()]);
        return assembly.GetType("Console")!.GetField("Said")!.GetValue(null)!.ToString()!.TrimEnd('\n').Split('\n');
    }
}
