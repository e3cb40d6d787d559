using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The advice for each body of a scene alone.</summary>
public sealed class BodyByBodyTests
{
    private const double Error = 1e-6;

    [Test]
    public void Free_slab_takes_longer_steps_than_a_heavy_top_and_both_keep_the_error()
    {
        ExactCase slab = ExactCase.Read("dzhanibekov_1e-3"), top = ExactCase.Read("lagrange_top");
        SceneDescription scene = new("slab and top", string.Empty, TimeSteps.Every(0.02, 1000), [Named("slab", slab), Named("top", top)]);

        Advice forAll = Advisor.Choose(scene, Error);
        BodyByBody found = BodyByBody.Of(scene, forAll, Error);

        // the slab has no pushes, so an integrator that is exact then needs no steps shorter than the whole scene
        Trial[] own = [.. found.Own.Select(advice => advice.Best)];
        Assert.That(found.Reached, Is.True);
        Assert.That(own[0].Rule.Name, Does.StartWith("Exact").And.Not.Contain("Gyroscopic").And.Not.Contain("Euler"));
        Assert.That(own[0].Step, Is.EqualTo(20));
        Assert.That(own[1].Step, Is.LessThan(1));
        Assert.That(AngleApart(slab, own[0].Rule.Name, own[0].Step), Is.LessThan(Error)); // measured 1.6e-13
        Assert.That(AngleApart(top, own[1].Rule.Name, own[1].Step), Is.LessThan(Error)); // measured 7.0e-7
        Assert.That(AngleApart(top, own[1].Rule.Name, own[0].Step), Is.GreaterThan(100 * Error));

        // in one scene the slab takes the top's step, and both have their own integrators
        Assert.That(found.OneStep.Select(trial => trial.Step), Is.All.EqualTo(own[1].Step));
        Assert.That(AngleApart(slab, found.OneStep[0].Rule.Name, found.OneStep[0].Step), Is.LessThan(Error)); // measured 2.3e-14
        Assert.That(found.OneStep[1], Is.SameAs(own[1]));

        Assert.That(found.OneRule.Select(trial => (trial.Rule, trial.Step)), Is.All.EqualTo((forAll.Best.Rule, forAll.Best.Step)));
        Trial[] timed = [.. own, .. found.OneRule, .. found.OneStep];
        Assert.That(timed.Select(trial => trial.Cost), Is.All.GreaterThan(0).And.All.LessThan(1));
        Assert.That(BodyByBody.CostOf(own), Is.EqualTo(own[0].Cost + own[1].Cost));
    }

    [Test]
    public void Body_for_which_no_integrator_keeps_the_bound_is_named_and_the_others_have_their_answer()
    {
        // x'' = 100 x: e^40 in 4 s
        BodyState start = new(new Vector3d(1e-3, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription flees = new BodyDescription("flees", Solids.Sphere(1, 0.5)) { Start = start }.With(new Repulsion(100));
        BodyDescription rests = new("rests", Solids.Sphere(1, 0.5));
        SceneDescription scene = new("two", string.Empty, TimeSteps.Every(0.1, 40), [flees, rests]);

        Advice forAll = Advisor.Choose(scene, 1e-3);
        BodyByBody found = BodyByBody.Of(scene, forAll, 1e-3);

        Assert.That(forAll.Reached, Is.False);
        Assert.That(found.Reached, Is.False);
        Assert.That(found.Own.Select(advice => advice.Reached), Is.EqualTo(new[] { false, true }));
        Assert.That(found.Own[0].Reason, Does.StartWith("chaos"));
        Assert.That(found.Own[0].Best.Error, Is.GreaterThan(1e-3));
        Assert.That(found.Own[1].Best.Error, Is.Zero);
        Assert.That(found.OneRule, Is.Empty);
        Assert.That(found.OneStep, Is.Empty);
    }

    private static BodyDescription Named(string name, ExactCase solved)
    {
        BodyDescription body = SolvedScene.Body(solved, "Exact");
        return body.Copy(name, body.Mass);
    }

    /// <summary>The largest angle to the solution within the 20 s of the scene, rad.</summary>
    private static double AngleApart(ExactCase solved, string integrator, double step)
    {
        double largest = double.NaN;
        foreach (ExactCase.Sample sample in solved.Samples.Where(sample => sample.Time > 0 && sample.Time <= 20))
        {
            // a sample between two steps is reached by a shorter one
            int whole = (int)Math.Floor((sample.Time / step) + 1e-9);
            double rest = sample.Time - (whole * step);
            TimeSteps steps = TimeSteps.Of([.. Enumerable.Repeat(step, whole), .. rest > 1e-9 * step ? [rest] : Array.Empty<double>()]);
            BodyState state = Scenery.Run(steps, SolvedScene.Body(solved, integrator), steps.Count);
            largest = double.MaxNumber(largest, Conserved.AngleBetween(state.Orientation, sample.Orientation));
        }

        return largest;
    }
}
