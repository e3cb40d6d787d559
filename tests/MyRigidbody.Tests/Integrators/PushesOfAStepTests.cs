using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests;

/// <summary>A step evaluates a push as often as the page says.</summary>
public sealed class PushesOfAStepTests
{
    private static IEnumerable<object[]> Rows =>
        from line in File.ReadLines(Root.File("docs/integrators.md")).SkipWhile(line => line != "<!-- kicks -->").Skip(3).TakeWhile(line => line != "<!-- end -->")
        let cells = line.Split('|', StringSplitOptions.TrimEntries)
        from rule in cells[1].Split(", ")
        select new object[] { rule.Trim('`'), int.Parse(cells[2], CultureInfo.InvariantCulture), int.Parse(cells[3], CultureInfo.InvariantCulture) };

    [TestCaseSource(nameof(Rows))]
    public void Page_says_how_often_a_push_is_evaluated(string integrator, int ofPose, int ofVelocity)
    {
        Assert.That(Asked(EffectTraits.ReadsPosition | EffectTraits.ReadsTime), Is.EqualTo(ofPose));
        Assert.That(Asked(EffectTraits.ReadsVelocity), Is.EqualTo(ofVelocity));
        Assert.That(Asked(EffectTraits.ReadsAngularVelocity), Is.EqualTo(ofVelocity));

        int Asked(EffectTraits reads)
        {
            int[] count = [0];
            Scenery.Run(TimeSteps.Every(0.1), Scenery.Body(integrator).With(new Counting(reads, count)), 1);
            return count[0];
        }
    }

    [Test]
    public void Page_has_every_rule_of_an_order_above_one() =>
        Assert.That(Rows.Select(row => row[0]), Is.EquivalentTo(Rules.All.Where(rule => rule.Order > 1).Select(rule => rule.Name)));

    private readonly struct Counting(EffectTraits reads, int[] count) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | reads;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => count[0]++;

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => count[0]++;
    }
}
