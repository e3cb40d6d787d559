using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// A body whose numbers exceed double precision is named with the time, by every integrator, and no state with an infinity or NaN can be read,
/// at any time.
/// </summary>
public sealed class StateOverflowTests
{
    private const double Step = 0.02;

    /// <summary>Causes of divergence in step 40 or later, each of another kind.</summary>
    private static readonly Dictionary<string, (Func<BodyDescription, BodyDescription> Act, string Named)> Acts = new()
    {
        ["a force"] = (body => body.With(new Force(new Vector3d(0, 1e300, 0)), 40 * Step), "effects[0] (force ("),
        ["a torque in world axes"] = (body => body.With(Torque.Constant(new Vector3d(0, 1e300, 0)), 40 * Step), "effects[0] (torque ("),
        ["a torque in body axes"] = (body => body.With(new Torque(new Vector3d(0, 0, 1e300), Vector3d.Zero, Vector3d.Zero, 0, inBody: true), 40 * Step), "effects[0] (torque ("),
        ["gravity"] = (body => body.With(new Gravity(new Vector3d(0, -1e300, 0)), 40 * Step), "effects[0] (gravity"),
        ["gravity and a push"] = (body => body.With(new Gravity(new Vector3d(0, -1e300, 0)), 40 * Step).With(new KeyPush(LabKey.R), 60 * Step), "effects[0] (gravity"),
        ["a push and gravity"] = (body => body.With(new KeyPush(LabKey.R), 0, 30 * Step).With(new Gravity(new Vector3d(0, -1e300, 0)), 40 * Step), "effects[1] (gravity"),
    };

    private static IEnumerable<object[]> Cases =>
        from rule in Scenery.Integrators
        from act in Acts.Keys
            // PhysX limits ω to 7 rad/s
        where !(rule.StartsWith("Unity", StringComparison.Ordinal) && act.StartsWith("a torque", StringComparison.Ordinal))
        select new object[] { rule, act };

    [TestCaseSource(nameof(Cases))]
    public void Body_that_diverges_is_named_and_stands_before_that_step(string rule, string act)
    {
        (Func<BodyDescription, BodyDescription> make, string named) = Acts[act];
        HashSet<(long, double)> found = [];
        foreach (long stepsAtOnce in new[] { 1, 7, 35, 200 })
        {
            foreach (bool looks in new[] { true, false })
            {
                Simulation simulation = new(TimeSteps.Every(Step), make(Scenery.Body(rule, "b")), Scenery.Busy("LabEuler", "beside"));
                Simulation sound = new(TimeSteps.Every(Step), Scenery.Body(rule, "b"), Scenery.Busy("LabEuler", "beside"));
                StateOverflowException error = Assert.Throws<StateOverflowException>(() => Run(simulation, stepsAtOnce, looks))!;
                Assert.That((error.Body, error.Number, error.Time), Is.EqualTo(("b", -1, (error.Step + 1) * Step)));
                Assert.That(error.Step, Is.InRange(40, 60));
                Assert.That(error.Message, Does.StartWith("body \"b\": ").And.Contains(" has diverged: no finite state at t = ").And.Contains(named));
                found.Add((error.Step, error.Time));

                // the states read are finite; the exception comes again; and the others have not moved on
                simulation.TryStep(100);
                Assert.That(IsFiniteOrRefused(simulation.Bodies[0]));
                sound.Step(simulation.StepsDone);
                Assert.That(simulation.Bodies[1].State, Is.EqualTo(sound.Bodies[1].State));
            }
        }

        Assert.That(found, Has.Count.EqualTo(1), "the step must not depend on who looked when: " + string.Join(", ", found));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Effects_that_feed_a_body_until_it_diverges_do_too(string rule)
    {
        foreach (int stepsAtOnce in new[] { 1, 10_000 })
        {
            Simulation simulation = new(TimeSteps.Every(0.1, 10_000), Scenery.Body(rule, "b").With(new Feeding()));
            ArithmeticException error = Assert.Catch<ArithmeticException>(() => Run(simulation, stepsAtOnce, looks: true))!;
            Assert.That(error, Is.InstanceOf<StateOverflowException>());
            Assert.That(simulation.Bodies[0].State.IsFinite);
        }
    }

    [TestCase("velocity", 1e200)]
    [TestCase("angularVelocity", 1e200)]
    [TestCase("velocity", 1e160)]
    public void Start_whose_energy_is_not_finite_is_refused(string name, double value)
    {
        Vector3d v = new(value, 0, 0);
        BodyDescription body = Scenery.Body("Exact");
        body.Start = name == "velocity"
            ? new BodyState(Vector3d.Zero, Quaterniond.Identity, v, Vector3d.Zero)
            : new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, v);
        Assert.That(() => new Simulation(TimeSteps.Every(1), body), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith(name + ": must leave a finite kinetic energy"));
        Assert.That(() => new Together(Scenery.Body("Exact"), TimeSteps.Every(1)).Add(body.Start), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith(name + ": must leave a finite kinetic energy"));
    }

    [Test]
    public void Body_that_is_lost_before_its_effect_begins_leaves_the_others_where_they_are()
    {
        // its state has not been tested since it began to coast, and was lost long before the torque wakes it
        BodyDescription lost = Scenery.Body("Exact", "lost").With(new Gravity(new Vector3d(1e300, 0, 0)), 0.5).With(new KeyPush(LabKey.R), 200);
        Simulation simulation = new(TimeSteps.Every(1), lost, Scenery.Busy("LabEuler", "other"));
        simulation.Step(100);
        BodyState before = simulation.Bodies[1].State;
        StateOverflowException error = Assert.Throws<StateOverflowException>(() => simulation.Step(150))!;
        Assert.That(error.Body, Is.EqualTo("lost"));
        Assert.That(error.Step, Is.LessThan(10));
        Assert.That(simulation.StepsDone, Is.EqualTo(100));
        Assert.That(simulation.Bodies[1].State, Is.EqualTo(before));
        Assert.That(() => simulation.Bodies[0].State, Throws.InstanceOf<StateOverflowException>());
        Assert.That(() => simulation.Save(), Throws.InstanceOf<StateOverflowException>());
    }

    private static bool IsFiniteOrRefused(Body body)
    {
        try
        {
            return body.State.IsFinite;
        }
        catch (StateOverflowException)
        {
            return true;
        }
    }

    private static void Run(Simulation simulation, long stepsAtOnce, bool looks)
    {
        while (simulation.StepsDone < Math.Min(200_000, simulation.Scene.Steps.Count))
        {
            simulation.Step(Math.Min(stepsAtOnce, simulation.Scene.Steps.Count - simulation.StepsDone));
            if (looks || simulation.StepsDone >= 200)
                Assert.That(simulation.Bodies[0].State.IsFinite);

            if (simulation.StepsDone >= 1000)
                Assert.That(Guard.IsFinite(simulation.Bodies[0].KineticEnergy));
        }
    }

    /// <summary>The faster the body, the harder it pushes.</summary>
    private readonly struct Feeding : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsVelocity;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            wrench.Force += 3 * mass.Mass * body.Velocity;
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            Wrench force = default;
            At(now, body, mass, ref force);
            impulse.Force += duration * force.Force;
        }
    }
}
