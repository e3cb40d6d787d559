using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Forbidden operations on a simulation are found and named, and changes of its description do not reach it.</summary>
public sealed class MisuseTests
{
    [TestCase("LabEuler")]
    [TestCase("ExplicitEuler")]
    public void Settings_changed_after_the_start_change_nothing(string rule)
    {
        BodyDescription body = Scenery.Busy(rule), other = Scenery.Busy(rule);
        Simulation simulation = new(TimeSteps.Every(0.02), body), expected = new(TimeSteps.Every(0.02), other);
        Together batch = new(body, TimeSteps.Every(0.02)), expectedBatch = new(other, TimeSteps.Every(0.02));
        batch.Add(body.Start);
        expectedBatch.Add(other.Start);
        for (int i = 0; i < 2; i++)
        {
            simulation.Step(40);
            expected.Step(40);
            batch.Step(40);
            expectedBatch.Step(40);
            Assert.That((simulation.Bodies[0].State, batch[0]), Is.EqualTo((expected.Bodies[0].State, expectedBatch[0])));
            body.Lab.Normalise = false;
            body.Lab.UnitRotation = true;
            body.Unity.Drag = 7;
            body.Start = BodyState.AtRest;
            body.Without(_ => true);
        }
    }

    [Test]
    public void Copy_has_settings_of_its_own()
    {
        BodyDescription body = Scenery.Body("LabEuler"), copy = body.Copy("copy", body.Mass);
        copy.Lab.Normalise = false;
        copy.Unity.Drag = 3;
        Assert.That((body.Lab.Normalise, body.Lab.UnitRotation, body.Unity.Drag), Is.EqualTo((true, false, 0.1)));
        body.Lab.UnitRotation = true;
        Assert.That(copy.Lab.UnitRotation, Is.False);
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Effect_that_steps_its_own_simulation_is_named(string rule)
    {
        foreach (Action<Simulation> misuse in new Action<Simulation>[] { s => s.Step(), s => s.Save(), s => s.Restore(_saved!) })
        {
            Holder holder = new();
            Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Body(rule, "b").With(new Calling(holder), 0.2));
            _saved = simulation.Save();
            holder.Call = () => misuse(simulation);
            BrokenEffectException error = Assert.Throws<BrokenEffectException>(() => simulation.Step(100))!;
            Assert.That((error.Body, simulation.StepsDone), Is.EqualTo(("b", 10L)));
            Assert.That(error.Message, Does.StartWith("body \"b\": effects[0]: ").And.Contains("simulation \"simulation\": is being stepped already"));
            holder.Call = () => { };
            simulation.Step(100);
            Assert.That(simulation.StepsDone, Is.EqualTo(110));
        }
    }

    [Test]
    public void Effect_that_steps_the_simulation_of_many_is_named()
    {
        Holder holder = new();
        BodyDescription body = Scenery.Body("Exact", "b").With(new Calling(holder));
        Together many = new(body, TimeSteps.Every(0.02));
        many.Add(body.Start);
        holder.Call = () => many.Step();
        Assert.That(() => many.Step(), Throws.InstanceOf<BrokenEffectException>().With.InnerException.Message.StartsWith("simulation \"together\": is being stepped already"));
        Assert.That(many.StepsDone, Is.Zero);
        holder.Call = () => { };
        Assert.That(() => many.Step(), Throws.Nothing);
    }

    [Test]
    public void Two_threads_in_one_simulation_are_found()
    {
        using ManualResetEventSlim isInside = new(), mayGo = new();
        Holder holder = new();
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Body("Exact", "b").With(new Calling(holder)));
        holder.Call = () =>
        {
            isInside.Set();
            mayGo.Wait();
        };
        Task first = Task.Run(() => simulation.Step());
        isInside.Wait();
        try
        {
            Assert.That(() => simulation.Step(), Throws.InvalidOperationException.With.Message.StartsWith("simulation \"simulation\": is being stepped already"));
        }
        finally
        {
            mayGo.Set();
        }

        first.Wait();
        Assert.That(simulation.StepsDone, Is.EqualTo(1));
        simulation.Step();
        Assert.That(simulation.StepsDone, Is.EqualTo(2));
    }

    [TestCase(0.02)]
    [TestCase(1e-17)]
    [TestCase(1e9)]
    public void As_many_steps_as_there_are_may_be_coasted(double step)
    {
        foreach (Vector3d moments in new[] { new Vector3d(1, 1, 1), new Vector3d(1, 1, 2), new Vector3d(1, 2, 3) })
        {
            BodyDescription body = new("b", MassProperties.FromPrincipal(1, moments))
            {
                Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0, 0, 1e-3)),
            };
            Simulation simulation = new(TimeSteps.Every(step), body);
            Together batch = new(body, TimeSteps.Every(step));
            batch.Add(body.Start);
            simulation.Step(long.MaxValue);
            batch.Step(long.MaxValue);
            Assert.That(simulation.StepsDone, Is.EqualTo(long.MaxValue));
            BodyState end = simulation.Bodies[0].State;
            Assert.That(end.Position.X / (step * long.MaxValue), Is.EqualTo(1).Within(1e-12));
            Assert.That(end.Orientation.Length, Is.EqualTo(1).Within(1e-12));
            Assert.That(batch[0], Is.EqualTo(end));
            Assert.That(() => simulation.Step(), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }

    [ThreadStatic]
    private static SavedSimulation? _saved;

    private sealed class Holder
    {
        public Action Call { get; set; } = () => { };
    }

    /// <summary>Does what an effect must not do.</summary>
    private readonly struct Calling(Holder holder) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => holder.Call();

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => holder.Call();
    }
}
