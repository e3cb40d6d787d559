using NUnit.Framework;
using RigidBodyDynamics.Lab.Bench;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>What bench compares is comparable. That it runs is a check of .ci/run: no test takes time.</summary>
public sealed class BenchTests
{
    [Test]
    public void Step_written_by_hand_comes_to_the_bits_of_the_library_s()
    {
        Vector3d gravity = new(0, -9.81, 0), force = new(5, 0, 0);
        BodyDescription cube = new BodyDescription("cube", MassProperties.FromPrincipal(1, new Vector3d(0.5, 0.5, 0.5)))
        {
            Integrator = "LabEuler",
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
        }.With(new Gravity(gravity)).With(new DecayPerStep(0.98, 0.98)).With(new Force(force)).With(new Key(LabKey.R));
        HandWritten byHand = new(cube.Start, cube.Mass, force, gravity, 0.98, 0.02);
        byHand.Step(0, 500);
        Assert.That(byHand.State, Is.EqualTo(Scenery.Run(TimeSteps.Every(0.02), cube, 500)));
    }

    [Test]
    public void Every_ratio_is_of_things_that_are_measured()
    {
        // a name that nothing has would silently leave a ratio out
        string[] measured = [.. new[] { Suite.Rules(), Suite.ByHand(), Suite.Effects(), Suite.Shapes(), Suite.Denormals(), Suite.Many(1000) }
            .SelectMany(group => group).Select(measurement => measurement.What)];
        Assert.That(Ratios.Names.Where(name => !measured.Contains(name)), Is.Empty);
        Assert.That(Ratios.Names.Count(), Is.GreaterThan(20));
    }

    [Test]
    public void Measurement_gives_median_spread_and_allocation()
    {
        Measurement quiet = new("quiet", 10, 1, () => count => Thread.SpinWait((int)Math.Min(count, 100)));
        Measurement loud = new("loud", 10, 1, () => count => GC.KeepAlive(new byte[1000 * Math.Min(count, 100)]));
        Measurement.Take([quiet, loud], 3, 1e-4, _ => { });
        Assert.That(quiet.Median, Is.GreaterThan(0));
        Assert.That(quiet.Spread.Low, Is.LessThanOrEqualTo(quiet.Median));
        Assert.That(quiet.Spread.High, Is.GreaterThanOrEqualTo(quiet.Median));
        Assert.That(loud.BytesAllocated, Is.GreaterThan(0));
        Assert.That(quiet.RatioTo(quiet), Is.EqualTo(1));
    }
}
