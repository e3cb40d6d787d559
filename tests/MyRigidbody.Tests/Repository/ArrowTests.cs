using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The order of folders, which stands in the tables of ARCHITECTURE.md, is that of the code.</summary>
[Parallelizable(ParallelScope.All)]
public sealed partial class ArrowTests
{
    private const string Page = "ARCHITECTURE.md";

    [TestCase("MyRigidbody.Lab", "## The rooms of the command line")]
    [TestCase("MyRigidbody.Judge", "## The judge of scripts")]
    [TestCase("MyRigidbody.Core", "## The parts of the Core")]
    public void Arrows_between_folders_run_down_their_table(string project, string heading)
    {
        string part = Tree.Text(Page).Split(heading + "\n")[1].Split("\n## ")[0];
        string[] order = ["", .. Row().Matches(part).Select(row => row.Groups[1].Value)];
        (string From, string To, string What)[] found = Arrows.BetweenFiles(project);
        string Room(string file) => file.Contains('/') ? file.Split('/')[0] : string.Empty;
        string[] rooms = [.. found.SelectMany(arrow => new[] { Room(arrow.From), Room(arrow.To) }).Distinct()];
        string[] up = [.. found.Where(arrow => Array.IndexOf(order, Room(arrow.From)) > Array.IndexOf(order, Room(arrow.To))).Select(arrow => $"`{Room(arrow.From)}` → `{Room(arrow.To)}`")];

        Assert.That(rooms, Is.SubsetOf(order), $"a folder without a row in {Page}");
        Assert.That(up.Distinct(), Is.EquivalentTo(Up().Matches(part).Select(arrow => arrow.Value)), string.Join('\n', found
            .Where(arrow => Array.IndexOf(order, Room(arrow.From)) > Array.IndexOf(order, Room(arrow.To))).Select(arrow => $"{arrow.From} → {arrow.To}: {arrow.What}").Distinct()));
    }

    [TestCase("MyRigidbody.Lab")]
    [TestCase("MyRigidbody.Judge")]
    public void No_folder_refers_to_one_that_refers_to_it_whatever_lies_between(string project)
    {
        HashSet<(string From, string To)> arrows = [.. Arrows.BetweenFiles(project).Select(arrow => (From: Arrows.Folder(arrow.From), To: Arrows.Folder(arrow.To))).Where(arrow => arrow.From != arrow.To)];

        Assert.That(arrows, Is.Not.Empty);
        Assert.That(Arrows.Cycles(arrows), Is.Empty);
    }

    [Test]
    public void A_cycle_is_found_across_any_number_of_folders() =>
        Assert.That(Arrows.Cycles([("a", "b"), ("b", "c"), ("c", "b"), ("c", "d")]), Is.EquivalentTo(new[] { "b", "c" }));

    [GeneratedRegex(@"^\| `(\w+)` \|", RegexOptions.Multiline)]
    private static partial Regex Row();

    [GeneratedRegex(@"`\w+` → `\w+`")]
    private static partial Regex Up();
}
