using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The measurement within a given time leaves out steps, and nothing else.</summary>
public sealed class CostInTimeTests
{
    // hardly any: only what is measured however long it takes
    private const double NoTime = 1e-6;

    [Test]
    public void Without_time_every_integrator_is_still_tried_in_the_step_of_a_game()
    {
        CostFindings found = CostInTime.Of(Tumbling(), NoTime, _ => { });

        foreach (Rule rule in Rules.All)
        {
            Assert.That(found.InGame(rule).Step, Is.EqualTo(CostInTime.Game).Within(1e-12), rule.Name);
            Assert.That(found.InGame(rule).NanosecondsPerStep, Is.GreaterThan(0), rule.Name);
        }
    }

    [Test]
    public void Errors_are_those_of_the_command_line_and_in_its_order()
    {
        CostMotion motion = Tumbling();
        CostFindings found = CostInTime.Of(motion, NoTime, _ => { });
        CostFindings whole = CostFindings.Of(motion, new Effort(CostFindings.Parts.Length - 3, 1e-6, 1), _ => { });

        Assert.That(found.Trials.Select(Key), Is.EqualTo(whole.Trials.Where(trial => trial.Step > CostInTime.Game / 1.5).Select(Key)));

        static (Rule, double, double) Key(Trial trial) => (trial.Rule, trial.Step, trial.Error);
    }

    [Test]
    public void More_time_tries_shorter_steps_until_the_floor_is_reached()
    {
        CostMotion motion = Tumbling();
        CostFindings found = CostInTime.Of(motion, 2, _ => { });
        Trial[] exact = [.. found.Of(Rules.Exact)], lab = [.. found.Of(Rules.LabEuler)];

        // a free body: by Exact the first step is as good as any, and only those of a game's length and above are tried
        Assert.That(exact.Max(trial => trial.Error), Is.LessThan(1e-14)); // measured 7.3e-16
        Assert.That(exact.Min(trial => trial.Step), Is.GreaterThan(CostInTime.Game / 3));
        Assert.That(lab.Min(trial => trial.Step), Is.LessThan(CostInTime.Game / 3));
    }

    [Test]
    public void Clock_ticks_and_a_time_is_many_of_its_ticks()
    {
        double tick = StepClock.Tick();

        Assert.That(tick, Is.GreaterThan(0).And.LessThan(0.1));
        Assert.That(StepClock.SecondsAtOnce(tick), Is.AtLeast(40 * tick).And.AtLeast(0.002));
        Assert.That(StepClock.SecondsAtOnce(1e-4), Is.EqualTo(0.004));
    }

    private static CostMotion Tumbling()
    {
        BodyDescription body = new("slab", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { AngularVelocityInBody = new Vector3d(1, 1.1, 0.9) };
        SceneDescription scene = new("tumbling", string.Empty, TimeSteps.Until(2, 0.1), [body]);
        return new CostMotion(StepFree.Of(scene), Truth.Of(scene), IsSolved: false);
    }
}
