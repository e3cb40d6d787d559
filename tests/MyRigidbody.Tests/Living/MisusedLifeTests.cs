using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Forbidden operations on living bodies: refused by name, and no body has moved.</summary>
public sealed class MisusedLifeTests
{
    private static readonly Vector3d J = new(1, 2, 3), Huge = new(1e308, 0, 0);

    private static IEnumerable<TestCaseData> Calls =>
        from call in new (string Name, Action<Simulation, Body, Body> Do)[]
        {
            ("ApplyForce", (_, body, _) => body.ApplyForce(J)),
            ("ApplyForce at a point", (_, body, _) => body.ApplyForce(J, J, inBody: true)),
            ("ApplyTorque", (_, body, _) => body.ApplyTorque(J)),
            ("ApplyImpulse", (_, body, _) => body.ApplyImpulse(J)),
            ("ApplyAngularImpulse", (_, body, _) => body.ApplyAngularImpulse(J, inBody: true)),
            ("State", (_, body, _) => body.State = BodyState.AtRest),
            ("Change", (_, body, _) => body.Change(Scenery.Body("LabEuler"))),
            ("Add", (simulation, _, _) => simulation.Add(Scenery.Body("Exact"))),
            ("Add one who was removed", (simulation, _, gone) => simulation.Add(gone, BodyState.AtRest)),
            ("Remove", (simulation, body, _) => simulation.Remove(body)),
            ("Step", (simulation, _, _) => simulation.Step(0)),
            ("StepBy", (simulation, _, _) => simulation.StepBy(0.01)),
            ("Advance", (simulation, _, _) => simulation.Advance(0.001)),
            ("Threads", (simulation, _, _) => simulation.Threads = 2),
            ("Save", (simulation, _, _) => simulation.Save()),
        }
        from together in new[] { false, true }
        select new TestCaseData(call.Do, together).SetArgDisplayNames(call.Name, together ? "one of many" : "alone");

    [TestCaseSource(nameof(Calls))]
    public void Effect_that_changes_the_simulation_in_which_it_acts(Action<Simulation, Body, Body> call, bool together)
    {
        World world = new(together), other = new(together);
        world.Call.Do = () => call(world.Simulation, world.Body, world.Gone);

        Assert.That(
            () => world.Simulation.Step(10),
            Throws.TypeOf<BrokenEffectException>().With.InnerException.TypeOf<InvalidOperationException>()
                .And.InnerException.Message.StartsWith("simulation \"simulation\": is being stepped already"));

        // from 0.1 s on it acts
        Assert.That(world.Simulation.StepsDone, Is.EqualTo(5));
        world.Call.Do = () => { };
        world.Simulation.Step(5);
        other.Simulation.Step(10);
        Assert.That(world.States, Is.EqualTo(other.States));
        Assert.That((world.Simulation.Alpha, world.Simulation.Threads, world.Gone.IsRemoved), Is.EqualTo((0.0, other.Simulation.Threads, true)));
    }

    [TestCaseSource(nameof(Calls))]
    public void Thread_that_changes_a_simulation_while_another_steps_it(Action<Simulation, Body, Body> call, bool together)
    {
        World world = new(together), other = new(together);
        using ManualResetEventSlim isInside = new(), mayGo = new();
        world.Call.Do = () =>
        {
            isInside.Set();
            mayGo.Wait();
        };
        Task steps = Task.Run(() => world.Simulation.Step(10));
        isInside.Wait();
        try
        {
            Assert.That(
                () => call(world.Simulation, world.Body, world.Gone),
                Throws.InvalidOperationException.With.Message.StartsWith("simulation \"simulation\": is being stepped already"));
        }
        finally
        {
            mayGo.Set();
        }

        steps.Wait();
        other.Simulation.Step(10);
        Assert.That(world.States, Is.EqualTo(other.States));
    }

    [TestCase(0)]
    [TestCase(-1)]
    [TestCase(1025)]
    public void Number_of_threads_that_is_none(int threads)
    {
        Simulation simulation = new(TimeSteps.Every(0.02)) { Threads = 2 };
        Assert.That(
            () => simulation.Threads = threads,
            Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains($"Threads: must be from 1 to 1024, found {threads}"));
        Assert.That(simulation.Threads, Is.EqualTo(2));
    }

    [Test]
    public void Start_of_one_of_many_that_is_none()
    {
        World world = new(together: true), other = new(together: true);
        BodyState nowhere = new(new Vector3d(double.NaN, 0, 0), Quaterniond.Identity, J, J);
        world.Simulation.Step(3);
        other.Simulation.Step(3);

        Assert.That(() => world.Simulation.Add(world.Like, nowhere), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("position: must"));
        Assert.That(() => world.Simulation.Add(world.Gone, nowhere), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("position: must"));
        Assert.That(() => world.Body.State = nowhere, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("position: must"));

        Assert.That((world.Simulation.Bodies.Count, world.Gone.IsRemoved), Is.EqualTo((other.Simulation.Bodies.Count, true)));
        world.Simulation.Step(3);
        other.Simulation.Step(3);
        Assert.That(world.States, Is.EqualTo(other.States));
    }

    [TestCase("Exact", false)]
    [TestCase("Exact", true)]
    [TestCase("LabEuler", false)]
    [TestCase("LabEuler", true)]
    [TestCase("RungeKutta4", false)]
    [TestCase("RungeKutta4", true)]
    public void Force_under_which_a_step_finds_no_state_is_forgotten_with_that_step(string rule, bool together)
    {
        World world = new(together, rule), other = new(together, rule);
        world.Simulation.Step(3);
        other.Simulation.Step(3);
        // the others' forces still wait for the step that has not been taken
        world.Neighbour.ApplyForce(J);
        other.Neighbour.ApplyForce(J);
        world.Body.ApplyForce(Huge);

        StateOverflowException error = Assert.Throws<StateOverflowException>(() => world.Simulation.Step(4))!;

        Assert.That((error.Handle, error.Step, world.Simulation.StepsDone), Is.EqualTo((world.Body, 3L, 3L)));
        Assert.That(error.Message, Does.Contain("after step 3, under what was applied for this step"));
        Assert.That(world.States, Is.EqualTo(other.States));
        world.Simulation.Step(4);
        other.Simulation.Step(4);
        Assert.That(world.States, Is.EqualTo(other.States));
    }

    [Test]
    public void Force_that_waits_when_an_effect_breaks_goes_on_waiting([Values] bool together)
    {
        World world = new(together), other = new(together);
        world.Simulation.Step(5);
        other.Simulation.Step(5);
        world.Body.ApplyForce(J);
        other.Body.ApplyForce(J);
        world.Call.Do = () => throw new TimeoutException();
        Assert.That(() => world.Simulation.Step(), Throws.TypeOf<BrokenEffectException>());
        world.Call.Do = () => { };
        world.Simulation.Step();
        other.Simulation.Step();
        Assert.That(world.States, Is.EqualTo(other.States));
    }

    [Test]
    public void Frame_in_which_a_step_fails_has_taken_the_steps_before_and_is_not_made_up_for([Values] bool together)
    {
        World world = new(together), other = new(together);
        Assert.That(world.Simulation.Advance(0.05), Is.EqualTo(2));
        double rest = world.Simulation.Alpha;
        Assert.That(rest, Is.EqualTo(0.5).Within(1e-12)); // measured 0
        world.Call.Do = () => throw new TimeoutException();

        Assert.That(() => world.Simulation.Advance(0.2), Throws.TypeOf<BrokenEffectException>());

        Assert.That((world.Simulation.StepsDone, world.Simulation.Alpha), Is.EqualTo((5L, rest)));
        other.Simulation.Step(5);
        Assert.That(world.States, Is.EqualTo(other.States));

        Assert.That(() => world.Simulation.Advance(0.2, () => throw new TimeoutException()), Throws.TypeOf<TimeoutException>());
        Assert.That((world.Simulation.StepsDone, world.Simulation.Alpha), Is.EqualTo((5L, rest)));

        world.Call.Do = () => { };
        Assert.That(world.Simulation.Advance(0.02), Is.EqualTo(1));
    }

    private sealed class Call
    {
        public Action Do { get; set; } = () => { };
    }

    /// <summary>Bodies of which one has an effect that calls, from 0.1 s on; alone or stored together, and one that is gone.</summary>
    private sealed class World
    {
        public World(bool together, string rule = "Exact")
        {
            Like = Scenery.Body(rule).With(new Calling(Call), 0.1);
            for (int i = 0; i < 6; i++)
            {
                BodyDescription like = together ? Like : Like.Copy("body " + i, Like.Mass);
                Simulation.Add(like, new BodyState(i * J, Quaterniond.Identity, J, new Vector3d(1, 0.1 * i, 2)));
            }

            Body = Simulation.Bodies[3];
            Neighbour = Simulation.Bodies[2];
            Gone = Simulation.Bodies[5];
            Simulation.Remove(Gone);
        }

        public Call Call { get; } = new();

        public BodyDescription Like { get; }

        public Simulation Simulation { get; } = new(TimeSteps.Every(0.02)) { Threads = 1 };

        public Body Body { get; }

        public Body Neighbour { get; }

        public Body Gone { get; }

        public IEnumerable<BodyState> States => Simulation.Bodies.Select(body => body.State);
    }

    private readonly struct Calling(Call call) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => call.Do();

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => call.Do();
    }
}
