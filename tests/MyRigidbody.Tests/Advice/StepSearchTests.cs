using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The longest step below the bound is found among steps that can be typed and that coincide with the effects.</summary>
public sealed class StepSearchTests
{
    [Test]
    public void Steps_without_effects_in_time_have_three_digits_or_make_the_whole()
    {
        double[] steps = StepSizes.Of(SceneOf(7, body => body), 7);

        Assert.That(steps[0], Is.EqualTo(7));
        Assert.That(steps, Is.Ordered.Descending);
        // 1 % apart where there are more than some steps
        Assert.That(steps.Zip(steps.Skip(1)).Where(pair => pair.First < 0.5).Max(pair => pair.First / pair.Second), Is.LessThan(1.016)); // measured 1.01, where a digit more would be needed
        foreach (double step in steps.Where(step => Math.Abs((7 / step) - Math.Round(7 / step)) > 1e-9))
            Assert.That(step.ToString("G3", CultureInfo.InvariantCulture), Is.EqualTo(step.ToString("R", CultureInfo.InvariantCulture)));
    }

    [Test]
    public void No_step_goes_further_beyond_the_end_than_the_motion_is_known() => Assert.That(
        StepSizes.Of(SceneOf(7, body => body), 7).Max(step => StepSizes.Count(7, step) * step), Is.LessThanOrEqualTo(7 * Truth.Beyond));

    [Test]
    public void Steps_that_meet_the_beginnings_and_ends_of_effects_are_among_them()
    {
        SceneDescription scene = SceneOf(2, body => body.With(new Force(new Vector3d(1, 0, 0)), 5.0 / 60, 25.0 / 60).With(new KeyPush(LabKey.R), 0.25, 1));

        double[] aligned = [.. StepSizes.Aligned(scene, 2)];

        Assert.That(aligned[0], Is.EqualTo(5.0 / 60).Within(1e-15));
        Assert.That(aligned[1], Is.EqualTo(2.5 / 60).Within(1e-15));
        Assert.That(aligned, Is.SubsetOf(StepSizes.Of(scene, 2)));
        foreach (double step in aligned)
        {
            TimeSteps steps = TimeSteps.Until(2, step);
            foreach (double time in new[] { 5.0 / 60, 25.0 / 60, 0.25, 1 })
                Assert.That(steps.StartOf(steps.FirstAt(time)), Is.EqualTo(time).Within(1e-12), step.ToString("R", CultureInfo.InvariantCulture));
        }
    }

    [Test]
    public void Times_that_no_step_meets_have_none() => Assert.That(
        StepSizes.Aligned(SceneOf(2, body => body.With(new Force(new Vector3d(1, 0, 0)), 1.0 / 3, 0.7310585)), 2), Is.Empty);

    // moments 1, 1.5, 2 kg m², 3 N m, 4 rad/s: a short scene whose steps may be long
    [TestCase("Exact6", 1e-3, 0.3)]
    [TestCase("Exact4", 1e-3, 0.2)]
    public void Short_scene_is_given_steps_above_a_tenth_of_a_second(string rule, double error, double least)
    {
        BodyDescription top = new BodyDescription("top", MassProperties.FromPrincipal(1, new Vector3d(1, 1.5, 2)))
        {
            Start = new BodyState(Vector3d.Zero, new Quaterniond(0.97, 0.25, 0, 0).Normalized, Vector3d.Zero, new Vector3d(0.1, 0.2, 4)),
        }.With(new HeavyTop(new Vector3d(0, 0, 1), 3, new Vector3d(0, 0, 1)));
        SceneDescription scene = new("top", string.Empty, TimeSteps.Until(8, 0.02), [top]);

        Trial? longest = new StepSearch(scene, Truth.Of(scene, null, error), error).Longest(Rules.Named(rule), step => false);

        Assert.That(longest, Is.Not.Null);
        Assert.That(longest!.Step, Is.GreaterThan(least)); // measured 1.16, 0.638
        Assert.That(longest.Error, Is.LessThan(error));
    }

    [Test]
    public void Contest_of_one_has_no_second_and_of_two_is_decided_in_rounds_of_both()
    {
        SceneDescription scene = SceneOf(2, body => body.With(new KeyPush(LabKey.R)));
        Truth truth = Truth.Of(scene);
        Trial exact = Trial.Of(scene, truth, Rules.Exact, 0.1), dear = Trial.Of(scene, truth, Rules.Exact6, 0.001);

        Contest one = new([exact]), two = new([exact, dear]);

        Assert.That((one.Best, one.RunnerUp, one.RoundsOfBoth), Is.EqualTo((exact, (Trial?)null, 0)));
        Assert.That((two.Best, two.RunnerUp), Is.EqualTo((exact, dear)));
        Assert.That(two.RoundsOfBoth, Is.GreaterThan(0));
        Assert.That(two.RoundsWon, Is.EqualTo(two.RoundsOfBoth));
    }

    [Test]
    public void Interpolation_has_every_polynomial_of_degree_seven()
    {
        for (int power = 0; power <= 7; power++)
        {
            const double s = 1.37;
            double value = 0, rate = 0;
            for (int node = 0; node < 4; node++)
            {
                HermiteBasis basis = HermiteBasis.Of(node, s);
                double there = Math.Pow(node, power), slope = power == 0 ? 0 : power * Math.Pow(node, power - 1);
                value += (basis.Value * there) + (basis.Slope * slope);
                rate += (basis.ValueRate * there) + (basis.SlopeRate * slope);
            }

            Assert.That(value, Is.EqualTo(Math.Pow(s, power)).Within(1e-12)); // measured 1.8e-15
            Assert.That(rate, Is.EqualTo(power == 0 ? 0 : power * Math.Pow(s, power - 1)).Within(1e-11)); // measured 3.6e-14
        }
    }

    private static SceneDescription SceneOf(double duration, Func<BodyDescription, BodyDescription> describe) =>
        new("scene", string.Empty, TimeSteps.Until(duration, 0.02), [describe(new BodyDescription("body", Solids.Sphere(1, 0.5)))]);
}
