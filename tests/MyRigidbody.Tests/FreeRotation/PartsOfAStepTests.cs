using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A long step is taken in parts only where a part of it ends near the opposite of where it began.</summary>
public sealed class PartsOfAStepTests
{
    private static readonly TopShape Shape = new(new Vector3d(1, 2, 3), Quaterniond.Identity);

    [Test]
    public void Step_of_up_to_ten_seconds_of_an_ordinary_top_is_one_part()
    {
        foreach (double h in new[] { 1e-3, 0.02, 0.3, 1, 2.5, 10, -2.5 })
            Assert.That(Step(new Vector3d(1, 1.1, 0.9), h).IsIllConditioned, Is.False, $"{h}");
    }

    [Test]
    public void Step_after_one_that_needed_parts_is_judged_for_itself()
    {
        OrbitStep step = Step(new Vector3d(1.3582009856394497, 1.566076665914653, 0.7841661194265663), 19.744);
        Assert.That(step.IsIllConditioned, Is.True);
        step.Set(Shape, 1, 1, 0.1, 0.5);
        Assert.That(step.IsIllConditioned, Is.False);
    }

    // on the separatrix: the momentum turns over once and stays
    [TestCase(1.3582009856394497, 1.566076665914653, 0.7841661194265663, 19.744)]
    [TestCase(1.7083035966885758, 1.3071546979747501, -0.9857228933767057, 16.0926)]
    [TestCase(0.668949316567252, 1.920825760774699, -0.3866270735797599, 17.9235)]
    public void Step_that_turns_the_momentum_over_is_right_in_parts(double w1, double w2, double w3, double h)
    {
        Vector3d w = new(w1, w2, w3);
        Assert.That(Step(w, h).IsIllConditioned, Is.True);

        BodyDescription body = new("b", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { Rule = Rules.Exact };
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, w);
        BodyState inSteps = Scenery.Run(TimeSteps.Every(h / 1024), body, 1024), atOnce = new FreeMotion(body).At(h);
        double apart = Conserved.AngleBetween(inSteps.Orientation, atOnce.Orientation);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{apart:g2} rad"));
        Assert.That(apart, Is.LessThan(1e-13)); // measured at most 1.2e-14
    }

    private static OrbitStep Step(Vector3d w, double h)
    {
        double a1 = Shape.I1 * w.X * w.X + Shape.G1 * w.Y * w.Y, a3 = Shape.I3 * w.Z * w.Z + Shape.G3 * w.Y * w.Y;
        OrbitStep step = default;
        step.Set(Shape, a1, a3, Shape.M1 * w.X * w.X - Shape.M3 * w.Z * w.Z, h);
        return step;
    }
}
