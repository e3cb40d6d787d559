using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// An effect that fails in the first step in which it is evaluated is named, wherever states were read before and wherever its time begins;
/// nothing loops, and nothing has moved.
/// </summary>
public sealed class FirstStepTests
{
    private const double Step = 0.02;

    /// <summary>When the effect breaks: its window's start in steps, and what else acts.</summary>
    private static readonly Dictionary<string, (long First, Func<BodyDescription, BodyDescription> Also)> Windows = new()
    {
        ["at the start"] = (0, body => body),
        ["while the body is stepped"] = (50, body => body.With(new Force(new Vector3d(1, 0, 0)))),
        ["while the body coasts"] = (50, body => body.With(new Gravity(new Vector3d(0, -9.81, 0)))),
        ["where the body begins to coast, and damped"] = (50, body => body.With(new KeyPush(LabKey.R), 0, 30 * Step).With(new LinearDamping(0.1))),
        ["while the body lies"] = (50, body => AtRest(body)),
    };

    private static IEnumerable<object[]> Cases =>
        from rule in Scenery.Integrators
        from window in Windows.Keys
        from breaks in Enum.GetValues<Way>()
        select new object[] { rule, window, breaks };

    [TestCaseSource(nameof(Cases))]
    public void Effect_that_breaks_at_once_is_named_and_nothing_moves(string rule, string window, Way breaks)
    {
        (long first, Func<BodyDescription, BodyDescription> also) = Windows[window];
        foreach (Look look in Enum.GetValues<Look>())
        {
            foreach (long stepsAtOnce in new[] { 1, 7, 25, 1000 })
            {
                string which = $"{look}, {stepsAtOnce} at once";
                Simulation broken = Built(breaks), sound = Built(null);
                BrokenEffectException error = Assert.Throws<BrokenEffectException>(() => Run(broken, look, stepsAtOnce), which)!;
                int index = broken.Scene.Bodies[0].Effects.Count - 1;
                Assert.That(error.Body, Is.EqualTo("b"), which);
                Assert.That(error.Message, Does.StartWith($"body \"b\": effects[{index}]: must push with a finite force and torque").And.Contains($"in step {first} (broken: {breaks})"), which);
                Assert.That(error.Time, Is.EqualTo(first * Step).Within(1e-12).Or.EqualTo((first + 1) * Step).Within(1e-12), which);

                Assert.That(broken.StepsDone, Is.EqualTo(first), which);
                sound.Step(first);
                Assert.That(broken.Bodies[0].State, Is.EqualTo(sound.Bodies[0].State), which);
                Assert.That(() => broken.Step(), Throws.InstanceOf<BrokenEffectException>(), which);
                Assert.That(broken.Bodies[0].State, Is.EqualTo(sound.Bodies[0].State), which);
            }
        }

        Simulation Built(Way? way) =>
            new(TimeSteps.Every(Step), also(Scenery.Body(rule, "b")).With(new Breaking(way), first * Step, 200 * Step));
    }

    [Test]
    public void Scene_that_never_ended_ends()
    {
        // read after its first step, the body has coasted to where the torque begins
        BodyDescription body = new BodyDescription("b", Solids.Box(1, new Vector3d(1, 1, 1)))
            .With(new Breaking(Way.IsNaN), 1);
        Simulation simulation = new(TimeSteps.Every(1, 6), body);
        simulation.Step();
        Assert.That(simulation.Bodies[0].State, Is.EqualTo(BodyState.AtRest));
        Assert.That(() => simulation.Step(), Throws.InstanceOf<BrokenEffectException>());
        Assert.That(simulation.StepsDone, Is.EqualTo(1));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Effect_that_says_it_does_nothing_is_not_asked(string rule)
    {
        BodyDescription held = AtRest(Scenery.Body(rule, "b"));
        held.CanMove = held.CanTurn = false;
        Simulation simulation = new(TimeSteps.Every(Step), held.With(new Idle()), AtRest(Scenery.Body(rule, "c")).With(new Idle(), 0.1));
        Vector3d[] before = [.. simulation.Bodies.Select(body => body.State.Position)];
        simulation.Step(20);
        Assert.That(simulation.Bodies.Select(body => body.State.Position), Is.EqualTo(before));
    }

    private static void Run(Simulation simulation, Look look, long stepsAtOnce)
    {
        while (simulation.StepsDone < 200)
        {
            if (look == Look.State)
                _ = simulation.Bodies[0].State;
            else if (look == Look.Save)
                simulation.Restore(simulation.Save());

            simulation.Step(Math.Min(stepsAtOnce, 200 - simulation.StepsDone));
        }
    }

    private static BodyDescription AtRest(BodyDescription body)
    {
        body.Start = new BodyState(body.Start.Position, body.Start.Orientation, Vector3d.Zero, Vector3d.Zero);
        return body;
    }

    public enum Way
    {
        Throws,
        IsNaN,
        Overflows,
    }

    private enum Look
    {
        Never,
        State,
        Save,
    }

    private readonly record struct Breaking(Way? Way) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (Way == FirstStepTests.Way.Throws)
                throw new InvalidOperationException("no push\nat all");

            double size = Way switch { null => 0, FirstStepTests.Way.IsNaN => double.NaN, _ => 1e300 * (1e10 + now.Time) };
            impulse.Torque += new Vector3d(0, 0, size);
        }

        public override string ToString() => "broken: " + Way;
    }

    private readonly struct Idle : IPush
    {
        public EffectTraits Traits => EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => throw new NotSupportedException();

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => throw new NotSupportedException();
    }
}
