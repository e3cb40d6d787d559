using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>A scene whose physics depend on the step becomes one whose physics do not, or is refused.</summary>
public sealed class StepFreeTests
{
    [Test]
    public void Factor_a_step_becomes_the_rate_that_leaves_as_much_after_a_step()
    {
        SceneDescription scene = SceneOf(TimeSteps.Every(0.02, 500), body => body.With(new DecayPerStep(0.98, 0.5), 1, 2));

        Coasting found = Coasting.Free;
        foreach (Effect effect in StepFree.Of(scene).Bodies[0].Effects)
        {
            Assert.That((effect.From, effect.To), Is.EqualTo((1.0, 2.0)));
            ((ICoast)effect.Motion).AddTo(ref found, scene.Bodies[0].Mass);
        }

        Assert.That(found.LinearDampingRate, Is.EqualTo(-Math.Log(0.98) / 0.02).Within(1e-14)); // measured 1.3e-15
        Assert.That(found.AngularDampingRate, Is.EqualTo(Math.Log(2) / 0.02).Within(1e-13)); // measured 0
        Assert.That((found.LinearFactorPerStep, found.AngularFactorPerStep), Is.EqualTo((1.0, 1.0)));
    }

    [TestCase(1e-300)]
    [TestCase(1 - 1e-15)]
    public void Rate_is_right_for_the_smallest_and_the_mildest_factor(double factor)
    {
        SceneDescription scene = SceneOf(TimeSteps.Every(1, 2), body => body.With(new DecayPerStep(factor, 1)));

        Coasting found = Coasting.Free;
        foreach (Effect effect in StepFree.Of(scene).Bodies[0].Effects)
            ((ICoast)effect.Motion).AddTo(ref found, scene.Bodies[0].Mass);

        // e^(−y) near 1 has no more digits than 1 has
        Assert.That(found.LinearDampingRate, Is.EqualTo(-Math.Log(factor)).Within(Math.Max(2e-16, -1e-15 * Math.Log(factor)))); // measured 0, 2.0e-31
    }

    [Test]
    public void Bodies_and_all_other_effects_stay_as_they_are_and_the_scene_is_not_touched()
    {
        SceneDescription scene = SceneOf(TimeSteps.Every(0.02, 500), body => body
            .With(new Gravity(new Vector3d(0, -1, 0)))
            .With(new DecayPerStep(0.98, 0.98))
            .With(new Force(new Vector3d(1, 0, 0)), 0, 1));
        BodyDescription before = scene.Bodies[0];

        BodyDescription after = StepFree.Of(scene).Bodies[0];

        Assert.That(before.Effects.Count, Is.EqualTo(3));
        Assert.That(after.Effects[0], Is.SameAs(before.Effects[0]));
        Assert.That(after.Effects[^1], Is.SameAs(before.Effects[2]));
        Assert.That((after.Name, after.Rule, after.Mass), Is.EqualTo((before.Name, before.Rule, before.Mass)));
    }

    [Test]
    public void What_has_no_rate_is_refused_by_its_place()
    {
        Vector3d[] kicks = [new(1, 0, 0), new(2, 0, 0)];
        SceneDescription perStep = SceneOf(TimeSteps.Every(0.1, 2), body => body.With(new KeyPush(LabKey.R)).With(new PerStep(kicks, [])));
        SceneDescription stop = SceneOf(TimeSteps.Every(0.1, 2), body => body.With(new DecayPerStep(0, 1)));
        TimeSteps lengths = TimeSteps.Of([0.1, 0.1, 0.25]);
        SceneDescription uneven = SceneOf(lengths, body => body.With(new KeyPush(LabKey.R)).With(new DecayPerStep(0.98, 1)));

        Assert.That(() => StepFree.Of(perStep), Refused("bodies[0].effects[1]: ", "a force for each of 2 steps"));
        Assert.That(() => StepFree.Of(stop), Refused("bodies[0].effects[0]: ", "v × 0"));
        Assert.That(() => StepFree.Of(uneven), Refused("step[2]: ", "because of the factor per step in bodies[0].effects[1], found 0.25"));
        Assert.That(() => StepFree.Of(SceneOf(lengths, body => body.With(new LinearDamping(2)))), Throws.Nothing);
    }

    [Test]
    public void Rates_of_factors_are_named_by_their_places()
    {
        SceneDescription scene = SceneOf(TimeSteps.Every(0.02, 500), body => body.With(new KeyPush(LabKey.R)).With(new DecayPerStep(0.98, 1)));

        (string place, double linear, double angular) = StepFree.Rates(scene).Single();

        Assert.That(place, Is.EqualTo("bodies[0].effects[1]"));
        Assert.That(linear, Is.EqualTo(-Math.Log(0.98) / 0.02).Within(1e-14)); // measured 1.3e-15
        Assert.That(angular, Is.Zero);
    }

    private static NUnit.Framework.Constraints.IResolveConstraint Refused(string place, string value) =>
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith(place).And.Message.Contains(value);

    private static SceneDescription SceneOf(TimeSteps steps, Func<BodyDescription, BodyDescription> describe) =>
        new("scene", string.Empty, steps, [describe(new BodyDescription("body", Solids.Box(1, new Vector3d(1, 1, 1))))]);
}
