using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The motion with which integrators are compared is the true one, and its uncertainty is known.</summary>
public sealed class TruthTests
{
    private static readonly Vector3d Down = new(0, -9.81, 0);

    [Test]
    public void Error_of_a_fall_is_no_larger_than_its_stated_uncertainty()
    {
        BodyDescription body = Ball(new BodyState(new Vector3d(1, 2, 3), Quaterniond.Identity, new Vector3d(4, 5, 0), Vector3d.Zero)).With(new Gravity(Down));
        Truth truth = Truth.Of(SceneOf(3, body));

        foreach (double t in Times(3))
        {
            Vector3d expected = body.Start.Position + t * body.Start.Velocity + 0.5 * t * t * Down;
            Assert.That((truth.At(0, t).Position - expected).Length, Is.LessThanOrEqualTo((2 * truth.Uncertainty) + 1e-15)); // measured 1.6e-14
        }

        Assert.That(truth.Uncertainty, Is.LessThan(1e-13)); // measured 1.5e-14
    }

    [Test]
    public void Ball_that_spins_turns_by_rate_times_time()
    {
        Vector3d spin = new(0.3, -0.4, 1.2);
        Truth truth = Truth.Of(SceneOf(2, Ball(new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, spin))));

        foreach (double t in Times(2))
        {
            Quaterniond expected = Quaterniond.FromAxisAngle(spin, 1.3 * t);
            Assert.That(Conserved.AngleBetween(truth.At(0, t).Orientation, expected), Is.LessThanOrEqualTo((2 * truth.Uncertainty) + 1e-15)); // measured 4.8e-16
        }

        Assert.That(truth.Uncertainty, Is.LessThan(2e-15)); // measured 3.0e-16
    }

    [Test]
    public void Effect_that_begins_and_ends_within_a_base_step_does_so_exactly_there()
    {
        // from 1/3 s to 2/3 s: v = 1, x = 1/18 at its end and 1/3 more of a second at t = 1
        BodyDescription body = Ball(BodyState.AtRest).With(new Force(new Vector3d(3, 0, 0)), 1.0 / 3, 2.0 / 3);
        Truth truth = Truth.Of(SceneOf(1, body));

        Assert.That(truth.At(0, 1).Velocity.X, Is.EqualTo(1).Within(1e-13)); // measured 7.1e-15
        Assert.That(truth.At(0, 1).Position.X, Is.EqualTo((1.0 / 6) + (1.0 / 3)).Within((2 * truth.Uncertainty) + 1e-15)); // measured 1.1e-16
    }

    // ω = 4π: at whole and half seconds the ball stands still, whatever its phase
    [TestCase(0)]
    [TestCase(1e-3)]
    public void Swing_is_known_at_every_time_and_not_only_where_it_turns(double error)
    {
        const double stiffness = 315.82734083485946;
        BodyState start = new(new Vector3d(0.5, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        Truth truth = Truth.Of(SceneOf(20, Ball(start).With(new Spring(Vector3d.Zero, Vector3d.Zero, stiffness))), null, error);
        double rate = Math.Sqrt(stiffness), swing = Times(20).Max(t => Math.Abs(truth.At(0, t).Velocity.X + (0.5 * rate * Math.Sin(rate * t))));

        Assert.That(Times(20).Max(t => Math.Abs(truth.At(0, t).Position.X - (0.5 * Math.Cos(rate * t)))), Is.LessThanOrEqualTo(2 * (truth.Uncertainty + truth.Floor))); // measured 0.75 and 0.5 of it
        Assert.That(swing, Is.LessThanOrEqualTo(20 * rate * (truth.Uncertainty + truth.Floor))); // a derivative loses digits
        Assert.That(truth.Uncertainty, Is.LessThan(Math.Max(1e-3 * error, 1e-12)));
    }

    [Test]
    public void Body_whose_centre_of_mass_is_not_its_origin_is_known_between_its_states()
    {
        // it rotates about its centre of mass, which stays where it is
        Vector3d offset = new(0.3, 0, 0), spin = new(0, 0, 2);
        BodyDescription body = new("off", Solids.Sphere(1, 0.5).WithCenterOfMass(offset)) { Start = new BodyState(-1 * offset, Quaterniond.Identity, Vector3d.Zero, spin) };
        Truth truth = Truth.Of(SceneOf(3, body));

        foreach (double t in Times(3))
        {
            Vector3d expected = -0.3 * new Vector3d(Math.Cos(2 * t), Math.Sin(2 * t), 0);
            Assert.That((truth.At(0, t).Position - expected).Length, Is.LessThan(1e-13));
            Assert.That((truth.At(0, t).AngularVelocity - spin).Length, Is.LessThan(1e-11));
            Assert.That(truth.At(0, t).Velocity.Length, Is.LessThan(1e-11));
        }
    }

    [Test]
    public void Floor_shows_how_much_the_start_must_be_known()
    {
        // an unstable balance: the difference of x from 1 m, x'' = 100 (x − 1), grows by e^40 in 4 s; a ball in free flight keeps its place
        BodyState start = new(new Vector3d(1, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription unstable = Ball(start).With(new Repulsion(100)).With(new Force(new Vector3d(-100, 0, 0)));

        double stays = Truth.Of(SceneOf(4, Ball(start))).Floor, flees = Truth.Of(SceneOf(4, unstable)).Floor;

        Assert.That(stays, Is.LessThan(1e-15)); // measured 2.2e-16
        Assert.That(flees, Is.GreaterThan(1)); // measured 6.3; but for roundings 2.2e-16 · e^40 / 2 = 26
    }

    [Test]
    public void Scene_without_end_and_one_of_days_are_refused()
    {
        SceneDescription endless = new("endless", string.Empty, TimeSteps.Every(0.1), [Ball(BodyState.AtRest)]);

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

    /// <summary>Many times from 0 to a duration, in no common step with anything.</summary>
    private static IEnumerable<double> Times(double duration) => Enumerable.Range(0, 1000).Select(i => duration * (i * 0.6180339887498949 % 1));

    private static BodyDescription Ball(BodyState start) => new("ball", Solids.Sphere(1, 0.5)) { Start = start };

    private static SceneDescription SceneOf(double duration, BodyDescription body) =>
        new("scene", string.Empty, TimeSteps.Until(duration, Math.Min(0.05, duration)), [body]);
}
