using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies are added and removed while the simulation runs.</summary>
public sealed class ComingAndGoingTests
{
    private static readonly MassProperties Slab = Solids.Box(2, new Vector3d(1, 4, 9));

    private static readonly BodyState Tumbling =
        new(new Vector3d(1, 2, 3), new Quaterniond(0.5, 0.5, 0.5, 0.5), new Vector3d(4, 5, 6), new Vector3d(0.1, 0.2, -0.3));

    [Test]
    public void A_simulation_begins_without_bodies_and_has_no_end()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        simulation.Step(1000);
        Assert.That(simulation.Bodies, Is.Empty);
        Assert.That(simulation.Time, Is.EqualTo(1000 * 0.02));
    }

    [Test]
    public void A_body_that_comes_later_moves_as_if_its_start_were_time_zero([ValueSource(typeof(Scenery), nameof(Scenery.Integrators))] string integrator)
    {
        Simulation late = new(TimeSteps.Every(1 / 64.0)), early = new(TimeSteps.Every(1 / 64.0), Scenery.Body(integrator));
        late.Step(128);
        Body body = late.Add(Scenery.Body(integrator));
        late.Step(200);
        early.Step(200);
        Assert.That(body.State, Is.EqualTo(early.Bodies[0].State));
    }

    [Test]
    public void Windows_go_by_the_time_of_the_simulation_whenever_a_body_comes()
    {
        Simulation simulation = new(TimeSteps.Every(1 / 64.0));
        simulation.Step(64);
        Body body = simulation.Add(new BodyDescription("late", Slab).With(new Force(new Vector3d(4, 0, 0)), 0.5, 1.5));
        simulation.Step(128);
        // of the second in which the force acts, half a second was left: v = F t / m
        Assert.That(body.State.Velocity.X, Is.EqualTo(4 * 0.5 / 2).Within(1e-15));
    }

    [Test]
    public void Who_comes_after_the_last_step_stands_where_it_was_put()
    {
        foreach (TimeSteps steps in new[] { TimeSteps.Every(0.5, 2), TimeSteps.Of([0.5, 0.25]) })
        {
            Simulation simulation = new(steps, new BodyDescription("first", Slab));
            simulation.Step(2);
            BodyDescription late = new BodyDescription("late", Slab) { Start = Tumbling }.With(new Force(new Vector3d(1, 0, 0)), 0.5).With(new Spring(Vector3d.Zero, Vector3d.Zero, 1));
            Body one = simulation.Add(late), other = simulation.Add(late);
            simulation.Bodies[0].Change(late);
            Assert.That((one.State, other.State), Is.EqualTo((Tumbling, Tumbling)));
            Assert.That(new Explanation(one).ToString(), Does.StartWith(FormattableString.Invariant($"late, by Exact\n  from {simulation.Time} s: ")));
            Assert.That(() => simulation.Step(), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }

    [Test]
    public void Of_ten_bodies_those_that_stay_do_not_feel_that_others_come_and_go()
    {
        Simulation all = new(TimeSteps.Every(1 / 60.0)), alone = new(TimeSteps.Every(1 / 60.0));
        Body[] bodies = [.. Enumerable.Range(0, 10).Select(i => all.Add(Description(i)))];
        Body[] same = [.. Enumerable.Range(0, 10).Select(i => alone.Add(Description(i)))];
        for (int i = 0; i < 10; i += 2)
        {
            all.Step(7);
            all.Remove(bodies[i]);
        }

        all.Step(100);
        alone.Step(135);
        for (int i = 1; i < 10; i += 2)
            Assert.That(bodies[i].State, Is.EqualTo(same[i].State));

        Assert.That(all.Bodies, Is.EquivalentTo(bodies.Where((_, i) => i % 2 == 1)));
    }

    [Test]
    public void A_handle_knows_that_its_body_is_gone_and_is_never_another_s()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body first = simulation.Add(new BodyDescription("first", Slab));
        simulation.Remove(first);
        Body second = simulation.Add(new BodyDescription("second", Slab));
        Assert.That(first.IsRemoved, Is.True);
        Assert.That(second.IsRemoved, Is.False);
        Assert.That(first.Name, Is.EqualTo("first"));
        Assert.That(() => first.State, Throws.InvalidOperationException.With.Message.Contains("\"first\""));
        Assert.That(() => first.ApplyImpulse(new Vector3d(1, 0, 0)), Throws.InvalidOperationException);
        Assert.That(() => simulation.Remove(first), Throws.ArgumentException.With.Message.Contains("\"first\""));
        Assert.That(() => new Simulation(TimeSteps.Every(0.02)).Remove(second), Throws.ArgumentException);
        Assert.That(second.State.Velocity, Is.EqualTo(Vector3d.Zero));
    }

    [Test]
    public void Restore_knows_who_was_there()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body stays = simulation.Add(Description(0)), goes = simulation.Add(Description(3));
        simulation.Step(10);
        SavedSimulation saved = simulation.Save();
        BodyState stayed = stays.State, gone = goes.State;
        simulation.Remove(goes);
        Body comes = simulation.Add(Description(2));
        simulation.Step(10);
        simulation.Restore(saved);
        Assert.That(simulation.Bodies, Is.EqualTo(new[] { stays, goes }));
        Assert.That((stays.State, goes.State), Is.EqualTo((stayed, gone)));
        Assert.That((goes.IsRemoved, comes.IsRemoved), Is.EqualTo((false, true)));
        simulation.Step(10);
        Simulation straight = new(TimeSteps.Every(0.02), Description(0), Description(3));
        straight.Step(20);
        Assert.That(simulation.Bodies.Select(body => body.State), Is.EqualTo(straight.Bodies.Select(body => body.State)));
    }

    [Test]
    public void An_effect_cannot_add_or_remove_in_the_step_in_which_it_acts()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Meddler.Do = () => simulation.Add(new BodyDescription("more", Slab));
        simulation.Add(new BodyDescription("body", Slab).With(new Meddler()));
        Assert.That(() => simulation.Step(), Throws.TypeOf<BrokenEffectException>().With.InnerException.InstanceOf<InvalidOperationException>());
        Assert.That((simulation.Bodies.Count, simulation.StepsDone), Is.EqualTo((1, 0L)));
    }

    private static BodyDescription Description(int number)
    {
        BodyDescription body = new("body " + number, Slab) { Start = Tumbling };
        return number % 3 == 0 ? body : body.With(new Force(new Vector3d(number, 0, 1)), 0.3).With(new QuadraticDrag(0.1 * number));
    }

    private struct Meddler : IPush
    {
        public static Action? Do;

        public readonly EffectTraits Traits => EffectTraits.Moves;

        public readonly void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Do!();

        public readonly void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => Do!();
    }
}
