using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>An effect that fails during a run stops the step, is named, and leaves everything as it was.</summary>
public sealed class BrokenEffectTests
{
    private const long Fails = 30;

    private static IEnumerable<object[]> Cases =>
        from integrator in Scenery.Integrators
        from at in new[] { 1, 7, 50 }
        select new object[] { integrator, at };

    [TestCaseSource(nameof(Cases))]
    public void Force_that_is_not_finite_stops_the_step_and_says_so(string integrator, int stepsAtOnce)
    {
        foreach (double bad in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
        {
            Simulation broken = Built(bad), sound = Built(0);
            BrokenEffectException error = Assert.Throws<BrokenEffectException>(() =>
            {
                while (broken.StepsDone < 90)
                    broken.Step(stepsAtOnce);
            })!;
            Assert.That((error.Body, error.Effect), Is.EqualTo(("b", (object)new Gust(Fails, bad))));
            Assert.That(error.Time, Is.InRange(0.02 * Fails - 1e-9, 0.02 * (Fails + 1) + 1e-9));
            Assert.That(error.Message, Does.StartWith("body \"b\": effects[1]: must push with a finite force and torque").And.Contains("in step 30 (a gust)"));
            Assert.That(error.Message, Does.Not.Contain("\n"));

            // all bodies stand before the step, also those that had been stepped already
            Assert.That(broken.StepsDone, Is.EqualTo(Fails));
            sound.Step(Fails);
            Assert.That(broken.Bodies.Select(body => body.State), Is.EqualTo(sound.Bodies.Select(body => body.State)));

            // and say so again
            Assert.That(() => broken.Step(), Throws.InstanceOf<BrokenEffectException>());
            Assert.That(broken.Bodies.Select(body => body.State), Is.EqualTo(sound.Bodies.Select(body => body.State)));
        }

        Simulation Built(double bad) => new(
            TimeSteps.Every(0.02),
            Scenery.Busy(integrator, "a"),
            Scenery.Body(integrator, "b").With(new Gravity(new Vector3d(0, -9.81, 0))).With(new Gust(Fails, bad)).With(new KeyPush(LabKey.R)),
            Scenery.Busy("LabEuler", "c"),
            Scenery.Body("RungeKutta4", "d"),
            Scenery.Body("Exact", "e"));
    }

    [TestCase(1)]
    [TestCase(100)]
    public void Of_two_effects_that_fail_the_earlier_is_named_wherever_it_stands(int stepsAtOnce)
    {
        Simulation simulation = new(
            TimeSteps.Every(0.02),
            Scenery.Body("Exact", "later").With(new Gust(70, double.NaN)),
            Scenery.Body("LabEuler", "sooner").With(new Gust(40, double.NaN)),
            Scenery.Body("LabEuler", "latest").With(new Gust(80, double.NaN)));
        BrokenEffectException error = Assert.Throws<BrokenEffectException>(() =>
        {
            while (simulation.StepsDone < 100)
                simulation.Step(stepsAtOnce);
        })!;
        Assert.That((error.Body, simulation.StepsDone), Is.EqualTo(("sooner", 40L)));
    }

    [TestCaseSource(nameof(Cases))]
    public void Exception_of_an_effect_is_placed_and_leaves_the_state_before_the_step(string integrator, int stepsAtOnce)
    {
        Simulation broken = Built(throws: true), sound = Built(throws: false);
        BrokenEffectException error = Assert.Throws<BrokenEffectException>(() =>
        {
            while (broken.StepsDone < 90)
                broken.Step(stepsAtOnce);
        })!;
        Assert.That(error.Message, Does.StartWith("body \"b\": effects[0]: ").And.Contains("threw NotSupportedException (no wind today) at t = 0.6").And.Contains("in step 30"));
        Assert.That(error.InnerException, Is.InstanceOf<NotSupportedException>());
        sound.Step(broken.StepsDone);
        Assert.That(broken.StepsDone, Is.EqualTo(Fails));
        Assert.That(broken.Bodies.Select(body => body.State), Is.EqualTo(sound.Bodies.Select(body => body.State)));

        Simulation Built(bool throws) => new(
            TimeSteps.Every(0.02), Scenery.Busy(integrator, "a"), Scenery.Body(integrator, "b").With(new Strike(throws ? Fails : long.MaxValue)));
    }

    [TestCase(1)]
    [TestCase(200)]
    public void Integrator_that_diverges_by_itself_does_not_blame_an_effect(int stepsAtOnce)
    {
        // explicit Euler on a spring far beyond its stable step
        BodyDescription body = Scenery.Body("ExplicitEuler").With(new Spring(Vector3d.Zero, Vector3d.Zero, 1e12));
        Simulation simulation = new(TimeSteps.Every(1), body);
        Assert.That(
            () =>
            {
                while (simulation.StepsDone < 200)
                    simulation.Step(stepsAtOnce);
            },
            Throws.InstanceOf<StateOverflowException>().With.Message.StartsWith("body \"body\": ExplicitEuler has diverged: no finite state at t = "));
        Assert.That(simulation.Bodies[0].State.IsFinite);
        Assert.That(Guard.IsFinite(simulation.Bodies[0].KineticEnergy));
        Assert.That(() => simulation.Step(10), Throws.InstanceOf<StateOverflowException>());
    }

    /// <summary>Pushes soundly until a step.</summary>
    private readonly record struct Gust(long Fails, double Bad) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += new Vector3d(0, now.Step >= Fails ? Bad : 0, 0);

        public override string ToString() => "a gust";
    }

    private readonly record struct Strike(long Fails) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.Step >= Fails)
                throw new NotSupportedException("no wind today");
        }
    }
}
