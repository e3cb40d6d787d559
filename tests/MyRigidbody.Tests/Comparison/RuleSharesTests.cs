using NUnit.Framework;
using RigidBodyDynamics.Lab.Comparison;

namespace RigidBodyDynamics.Tests.Comparison;

/// <summary>The difference of the two bodies is explained without remainder.</summary>
public sealed class RuleSharesTests
{
    private static readonly TimeSteps Steps = TimeSteps.Until(10, 0.02);

    [TestCase(1, 1, 1)]
    [TestCase(1, 2, 3)]
    public void Shares_of_all_rules_add_up_to_the_whole(double x, double y, double z)
    {
        RuleShares found = RuleShares.Of(Lab(new Vector3d(x, y, z)), Steps);

        double distance = found.Shares.Sum(share => share.Distance), turn = found.Shares.Sum(share => share.Turn);
        // measured 1.1e-14 m, 7.1e-15 rad
        Assert.That(distance, Is.EqualTo(found.Whole.MeanDistance).Within(1e-13));
        Assert.That(turn, Is.EqualTo(found.Whole.MeanTurn).Within(1e-13));
        Assert.That(found.Whole.MeanDistance, Is.GreaterThan(1));
        Assert.That(found.Whole.MeanTurn, Is.GreaterThan(1));
    }

    [Test]
    public void Lab_in_the_shape_of_Unitys_step_moves_as_the_lab_does()
    {
        BodyDescription mine = Lab(new Vector3d(1, 2, 3)).Mine;

        Apart apart = Apart.Between(mine, Difference.LabInUnitysShape(mine), Steps);

        // measured 0 m and 3.6e-15 rad: the order of roundings is all that differs
        Assert.That(apart.Farthest.Distance, Is.LessThan(1e-14));
        Assert.That(apart.Farthest.Turn, Is.LessThan(2e-14));
    }

    [Test]
    public void All_rules_exchanged_give_Unitys_body_to_the_bit()
    {
        Pair pair = Lab(new Vector3d(1, 2, 3));
        BodyDescription last = Difference.Between(pair).Aggregate(Difference.LabInUnitysShape(pair.Mine), (body, rule) => rule.Exchange(body));

        Apart apart = Apart.Between(last, pair.Default, Steps);

        Assert.That(apart.Farthest.Distance, Is.Zero);
        Assert.That(apart.Farthest.Turn, Is.Zero);
    }

    [Test]
    public void Without_damping_only_drag_slows_the_push_of_an_arrow()
    {
        // 5 N for a second on 1 kg: the lab's body stops after 5 · 0.98 / 0.02 · 0.02 m, Unity's goes on at 5 m/s
        Pair pair = Lab(new Vector3d(1, 1, 1));
        RuleShares found = RuleShares.Of(pair, Steps);

        RuleShare damping = found.Shares.Single(share => share.Difference.Name == "damping");

        Assert.That(damping.Distance / found.Whole.MeanDistance, Is.EqualTo(1).Within(1e-5)); // measured 1.5e-6
    }

    [Test]
    public void Inertia_of_vertices_turns_a_third_as_far_as_the_solids()
    {
        // no limit is reached in the first half second, so one body turns by a third of the other's angle
        RuleShares found = RuleShares.Of(Lab(new Vector3d(1, 1, 1)), TimeSteps.Until(0.5, 0.02));
        RuleShare inertia = found.Shares.Single(share => share.Difference.Name == "inertia");
        SideBySide mine = new(TimeSteps.Until(0.5, 0.02), Lab(new Vector3d(1, 1, 1)).Mine);
        double sum = 0;
        while (mine.Step())
            sum += mine.Turned(0).Length;

        // twice mine's turn is missing to three times; the error of first-order orientation is at most 1e-5 of it
        Assert.That(inertia.Turn, Is.EqualTo(2 * sum / 25).Within(1e-5 * sum)); // measured 1.0e-6 of sum
    }

    [Test]
    public void A_body_of_Unitys_belongs_to_the_body_before_it()
    {
        BodyDescription mine = new("a", Solids.Box(1, new Vector3d(1, 1, 1)));
        BodyDescription unity = new("b", Solids.Box(1, new Vector3d(1, 1, 1))) { Rule = Rules.UnityRigidbody };
        BodyDescription alone = new("c", Solids.Sphere(1, 1));
        alone.With(new LinearDamping(0.3)).With(new AngularDamping(0.2));

        IReadOnlyList<Pair> pairs = Pair.Of(Scenes.FileOf(Steps, mine, unity, alone));

        Assert.That(pairs.Count, Is.EqualTo(2));
        Assert.That(pairs[0].Default, Is.SameAs(unity));
        Assert.That(pairs[1].Mine, Is.SameAs(alone));
        Assert.That(pairs[1].Default.Unity.Drag, Is.EqualTo(0.3));
        Assert.That(pairs[1].Default.Unity.AngularDrag, Is.EqualTo(0.2));
        Assert.That(pairs[1].Default.Effects, Is.Empty);
    }

    private static Pair Lab(Vector3d edges) => Scenes.Lab(edges);
}
