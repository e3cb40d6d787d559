using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The ways of a value, which stand in ARCHITECTURE.md hop by hop, are those of the code.</summary>
[Parallelizable(ParallelScope.All)]
public sealed partial class HopsTests
{
    private static readonly Way[] Ways = [.. Line().Matches(Tree.Text("ARCHITECTURE.md").ReplaceLineEndings(" ").Replace("  ", " "))
        .Select(line => new Way(line.Groups[1].Value, int.Parse(line.Groups[2].Value), [.. Hop().Matches(line.Groups[3].Value).Select(hop => (hop.Groups[2].Value, hop.Groups[1].Value == "⇢"))]))];

    private static readonly Calls Calls = new(Ways.SelectMany(way => way.Members.Select(hop => hop.Name)), "MyRigidbody.Core", "MyRigidbody.Lab", "UnityProject/Assets/MyRigidbody/Scripts");

    [Test]
    public void Four_ways_of_a_value_are_shown() => Assert.That(Ways.Select(way => way.Name), Is.EqualTo(new[]
    {
        "A key to the pose", "The length of a step through `cost`", "A description's inertia to the step", "A body among a million",
    }));

    [TestCaseSource(nameof(Ways))]
    public void Every_hop_of_a_way_is_a_call_in_the_code_and_counted(Way way)
    {
        string[] missing = [.. way.Members.Zip(way.Members.Skip(1))
            .Where(hop => !(hop.Second.IsThroughDelegate ? Calls.MayBeThroughDelegate(hop.First.Name, hop.Second.Name) : Calls.AreDirect(hop.First.Name, hop.Second.Name)))
            .Select(hop => $"{hop.First.Name} → {hop.Second.Name}")];

        Assert.That(missing, Is.Empty);
        Assert.That(way.Members, Has.Length.EqualTo(way.Hops + 1));
    }

    [Test]
    public void A_hop_that_is_left_out_or_that_nobody_takes_is_no_call()
    {
        Assert.That(Calls.AreDirect("Simulation.Run", "Simulation.RunTo"), Is.True);
        Assert.That(Calls.AreDirect("Simulation.Run", "Mover.Advance"), Is.False);
        Assert.That(Calls.AreDirect("Mover.Advance", "Simulation.Run"), Is.False);
        Assert.That(Calls.AreDirect("Team.TakeParts", "Parts.Work"), Is.False);
        Assert.That(Calls.MayBeThroughDelegate("Team.TakeParts", "Parts.Step"), Is.False);
    }

    [GeneratedRegex(@"\*\*([^*]+)\*\*, (\d+) hops: ((?:[→⇢ ]*`[\w.]+`)+)")]
    private static partial Regex Line();

    [GeneratedRegex(@"([→⇢]?) *`([\w.]+)`")]
    private static partial Regex Hop();

    /// <summary>A way: its value, the number of hops on the page, and the members that it passes.</summary>
    public sealed record Way(string Name, int Hops, (string Name, bool IsThroughDelegate)[] Members)
    {
        public override string ToString() => Name;
    }
}
