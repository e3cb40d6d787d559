using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>The advice holds when it is run, and an impossible error bound is reported as such.</summary>
public sealed class AdvisorTests
{
    private static readonly Vector3d Down = new(0, -9.81, 0);

    [TestCase(0.1)]
    [TestCase(0.01)]
    public void Advice_is_kept_by_a_run_of_its_own(double error)
    {
        Advice advice = Advisor.Choose(Fall(), error);

        TimeSteps steps = TimeSteps.Until(2, advice.Best.Step);
        BodyDescription body = Ball();
        body.Rule = advice.Best.Rule;
        BodyState end = Scenery.Run(steps, body, steps.Count);
        // 2 s of fall from rest, and a rotation for 2 s about z
        double distance = (end.Position - 2 * Down).Length;
        double angle = Conserved.AngleBetween(end.Orientation, Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), 2));

        Assert.That(advice.Reached, Is.True);
        Assert.That(advice.Reason, Is.Empty);
        Assert.That(advice.Best.Error, Is.LessThan(error));
        Assert.That(Math.Max(distance, angle), Is.LessThan(error));
        Assert.That(distance, Is.LessThanOrEqualTo(advice.Best.PositionError + (2 * advice.Truth.Uncertainty) + 1e-12));
    }

    // the period is half a second, so at whole seconds the ball stands still and its phase does not show
    [TestCase(1e-3)]
    [TestCase(1e-5)]
    [TestCase(1e-9)]
    public void Spring_that_oscillates_in_phase_with_whole_seconds_keeps_the_bound_at_every_step(double error)
    {
        const double stiffness = 315.82734083485946, mass = 2, duration = 20;
        BodyState start = new(new Vector3d(0, 0.5, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(mass, 0.5)) { Start = start }
            .With(new Gravity(Down)).With(new Spring(Vector3d.Zero, new Vector3d(0, 1, 0), stiffness));

        Advice advice = Advisor.Choose(new SceneDescription("spring", string.Empty, TimeSteps.Until(duration, 0.02), [body]), error);

        body.Rule = advice.Best.Rule;
        Simulation simulation = new(TimeSteps.Until(duration, advice.Best.Step), body);
        double rest = 1 + (Down.Y * mass / stiffness), largest = 0;
        while (simulation.StepsDone < simulation.Scene.Steps.Count)
        {
            simulation.Step();
            double right = rest + ((start.Position.Y - rest) * Math.Cos(Math.Sqrt(stiffness / mass) * simulation.Time));
            largest = Math.Max(largest, Math.Abs(simulation.Bodies[0].State.Position.Y - right));
        }

        Assert.That(advice.Reached, Is.True);
        Assert.That(largest, Is.LessThan(error)); // measured 1.0e-3, 9.7e-6, 9.9e-10
        Assert.That(largest, Is.LessThanOrEqualTo(advice.Best.Error + advice.Truth.Uncertainty + 1e-12));
    }

    // after 20 s it is where it was, so an integrator that does not move it at all is right at that time
    [Test]
    public void Step_as_long_as_an_oscillation_is_sampled_within()
    {
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(2, 0.5)) { Start = new BodyState(new Vector3d(0.5, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero) }
            .With(new Spring(Vector3d.Zero, Vector3d.Zero, 315.82734083485946));
        SceneDescription scene = new("spring", string.Empty, TimeSteps.Until(20, 0.02), [body]);

        Trial trial = Trial.Of(scene, Truth.Of(scene), Rules.ExplicitEuler, 20);

        Assert.That(trial.Steps, Is.EqualTo(1));
        Assert.That(trial.Error, Is.GreaterThan(0.5)); // measured 1.0: where it stands and where the swing is on the other side
    }

    [Test]
    public void Runner_up_moves_by_another_integrator_and_keeps_the_bound_too()
    {
        Advice advice = Advisor.Choose(Fall(), 0.1);

        Assert.That(advice.RunnerUp, Is.Not.Null);
        Assert.That(advice.RunnerUp!.Rule, Is.Not.SameAs(advice.Best.Rule));
        Assert.That(advice.RunnerUp.Error, Is.LessThan(0.1));
        Assert.That(advice.Factor, Is.EqualTo(advice.RunnerUp.Cost / advice.Best.Cost));
    }

    [Test]
    public void Error_below_the_last_bit_is_a_rounding_floor()
    {
        Advice advice = Advisor.Choose(Fall(), 1e-17);

        Assert.That(advice.Reached, Is.False);
        Assert.That(advice.Reason, Does.StartWith("rounding floor"));
        Assert.That(advice.RunnerUp, Is.Null);
        Assert.That(advice.Factor, Is.NaN);
        Assert.That(advice.Best.Error, Is.LessThan(0.01));
    }

    [Test]
    public void Motion_that_the_last_bit_decides_is_chaos()
    {
        // x'' = 100 x: e^40 in 4 s
        BodyState start = new(new Vector3d(1e-3, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(1, 0.5)) { Start = start }
            .With(new Repulsion(100));

        Advice advice = Advisor.Choose(new SceneDescription("flees", string.Empty, TimeSteps.Every(0.1, 40), [body]), 1e-3);

        Assert.That(advice.Reached, Is.False);
        Assert.That(advice.Reason, Does.StartWith("chaos"));
    }

    [TestCase(0)]
    [TestCase(-1)]
    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    public void Bound_that_is_none_is_refused(double error) => Assert.That(
        () => Advisor.Choose(Fall(), error),
        Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("error: must be finite and above zero"));

    [Test]
    public void Integrator_that_diverges_has_an_infinite_error_and_an_infinite_cost()
    {
        BodyState start = new(new Vector3d(1, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(1, 0.5)) { Start = start }
            .With(new Spring(Vector3d.Zero, Vector3d.Zero, 1e12));
        SceneDescription scene = new("stiff", string.Empty, TimeSteps.Every(0.1, 1000), [body]);
        Truth truth = new(0.1, 0, [new TruthSample(1000, 0, [start])]);

        Trial trial = Trial.Of(scene, truth, Rules.LabEuler, 0.1);
        StepClock.Take([trial], 1e-6, 1);

        double[] found = [trial.AngleError, trial.PositionError, trial.EnergyDrift, trial.MomentumDrift, trial.NanosecondsPerStep, trial.Cost];
        Assert.That(found, Is.All.EqualTo(double.PositiveInfinity));
    }

    // a push at the beginning alone makes the first steps the most expensive
    [Test]
    public void Long_run_is_timed_at_sixteen_places_spread_over_all_of_it()
    {
        Truth truth = new(0.1, 0, [new TruthSample(7, 0, [BodyState.AtRest]), new TruthSample(20, 0, [BodyState.AtRest])]);

        Trial trial = Trial.Of(Fall(), truth, Rules.LabEuler, 1e-4);

        Assert.That(trial.Steps, Is.EqualTo(20_000));
        Assert.That(new TimedRun(trial.Scene).Places, Is.EqualTo(Enumerable.Range(0, 16).Select(i => 1250L * i)));
        Assert.That(new TimedRun(trial.Scene).Nanoseconds(1e-6), Is.GreaterThan(0));
    }

    [Test]
    public void Error_of_a_trial_is_that_of_the_closed_form()
    {
        // LabEuler falls g t h / 2 too far: 0.0981 m in 2 s at steps of 0.01 s; the spin about one axis it gets nearly right
        Truth truth = new(0.1, 0, [new TruthSample(20, 0, [new BodyState(
            2 * Down, Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), 2), 2 * Down, new Vector3d(0, 0, 1))])]);

        Trial trial = Trial.Of(Fall(), truth, Rules.LabEuler, 0.01);

        Assert.That(trial.Step, Is.EqualTo(0.01).Within(1e-17)); // measured 0
        Assert.That(trial.Steps, Is.EqualTo(200));
        Assert.That(trial.PositionError, Is.EqualTo(0.0981).Within(5e-14)); // measured 9.4e-15
        // ½ h ω is tan of the angle a step: h³ω³/12 a step
        Assert.That(trial.AngleError, Is.EqualTo(200 * 1e-6 / 12).Within(1e-9)); // measured 2.5e-10
        Assert.That(trial.EnergyDrift, Is.LessThan(1e-14)); // measured 1.8e-15
        Assert.That(trial.MomentumDrift, Is.LessThan(1e-15)); // measured 0
    }

    private static BodyDescription Ball() => new BodyDescription("ball", Solids.Sphere(1, 0.5))
    {
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(0, 0, 1)),
    }.With(new Gravity(Down));

    private static SceneDescription Fall() => new("fall", string.Empty, TimeSteps.Every(0.02, 100), [Ball()]);
}
