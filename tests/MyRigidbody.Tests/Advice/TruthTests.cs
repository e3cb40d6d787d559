using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The motion that rules are compared with is the true one, and knows how true.</summary>
public sealed class TruthTests
{
    private static readonly Vector3d Down = new(0, -9.81, 0);

    [Test]
    public void Fall_is_off_the_closed_form_by_no_more_than_it_says()
    {
        BodyDescription body = Ball(new BodyState(new Vector3d(1, 2, 3), Quaterniond.Identity, new Vector3d(4, 5, 0), Vector3d.Zero)).With(new Gravity(Down));
        Truth truth = Truth.Of(SceneOf(3, body));

        foreach (TruthSample sample in truth.Samples)
        {
            double t = sample.At * truth.BaseStep;
            Vector3d expected = body.Start.Position + t * body.Start.Velocity + 0.5 * t * t * Down;
            Assert.That((sample.Bodies[0].Position - expected).Length, Is.LessThanOrEqualTo((2 * truth.Uncertainty) + 1e-15)); // measured 1.6e-14
        }

        Assert.That(truth.Samples.Count, Is.EqualTo(20));
        Assert.That(truth.Samples[^1].At, Is.EqualTo(30));
        Assert.That(truth.Uncertainty, Is.LessThan(1e-13)); // measured 1.5e-14
    }

    [Test]
    public void Ball_that_spins_turns_by_rate_times_time()
    {
        Vector3d spin = new(0.3, -0.4, 1.2);
        Truth truth = Truth.Of(SceneOf(2, Ball(new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, spin))));

        foreach (TruthSample sample in truth.Samples)
        {
            Quaterniond expected = Quaterniond.FromAxisAngle(spin, 1.3 * sample.At * truth.BaseStep);
            Assert.That(Conserved.AngleBetween(sample.Bodies[0].Orientation, expected), Is.LessThanOrEqualTo((2 * truth.Uncertainty) + 1e-15)); // measured 4.8e-16
        }

        Assert.That(truth.Uncertainty, Is.LessThan(2e-15)); // measured 3.0e-16
    }

    [Test]
    public void Effect_that_begins_and_ends_within_a_base_step_does_so_exactly_there()
    {
        // from 1/3 s to 2/3 s: v = 1, x = 1/18 at its end and 1/3 more of a second at t = 1
        BodyDescription body = Ball(BodyState.AtRest).With(new Force(new Vector3d(3, 0, 0)), 1.0 / 3, 2.0 / 3);
        Truth truth = Truth.Of(SceneOf(1, body));

        Assert.That(truth.Samples[^1].Bodies[0].Velocity.X, Is.EqualTo(1).Within(2e-15)); // measured 4.4e-16
        Assert.That(truth.Samples[^1].Bodies[0].Position.X, Is.EqualTo((1.0 / 6) + (1.0 / 3)).Within((2 * truth.Uncertainty) + 1e-15)); // measured 1.1e-16
    }

    [TestCase(0.02)]
    [TestCase(0.3)]
    [TestCase(0.95)]
    [TestCase(3)]
    [TestCase(25.5)]
    public void Every_scene_has_ten_samples_or_more_and_its_end_is_one(double duration)
    {
        Truth truth = Truth.Of(SceneOf(duration, Ball(BodyState.AtRest)));

        Assert.That(truth.Samples.Count, Is.GreaterThanOrEqualTo(10));
        Assert.That(truth.Samples[^1].At * truth.BaseStep, Is.EqualTo(duration).Within(1e-14)); // measured 5.6e-17
    }

    [Test]
    public void Floor_shows_how_much_the_start_must_be_known()
    {
        // an unstable balance: what x is off 1 m, x'' = 100 (x − 1), grows by e^40 in 4 s; a ball in free flight keeps its place
        BodyState start = new(new Vector3d(1, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription unstable = Ball(start).With(new Repulsion(100)).With(new Force(new Vector3d(-100, 0, 0)));

        double stays = Truth.Of(SceneOf(4, Ball(start))).Floor, flees = Truth.Of(SceneOf(4, unstable)).Floor;

        Assert.That(stays, Is.LessThan(1e-15)); // measured 2.2e-16
        Assert.That(flees, Is.GreaterThan(1)); // measured 6.3; but for roundings 2.2e-16 · e^40 / 2 = 26
    }

    [Test]
    public void Scene_without_end_and_one_of_days_are_refused()
    {
        Scene endless = new("endless", string.Empty, TimeSteps.Every(0.1), [Ball(BodyState.AtRest)]);

        Assert.That(() => Truth.Of(endless), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("duration: must be at most"));
        Assert.That(() => Truth.Of(SceneOf(1e6, Ball(BodyState.AtRest))), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("1000000"));
    }

    [Test]
    public void Samples_must_follow_each_other()
    {
        TruthSample one = new(1, 0, [BodyState.AtRest]);

        Assert.That(() => new Truth(0.1, 0, []), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Truth(0.1, 0, [one, one]), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new TruthSample(0, 0, [BodyState.AtRest]), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    private static BodyDescription Ball(BodyState start) => new("ball", Solids.Sphere(1, 0.5)) { Start = start };

    private static Scene SceneOf(double duration, BodyDescription body) =>
        new("scene", string.Empty, TimeSteps.Until(duration, Math.Min(0.05, duration)), [body]);
}
