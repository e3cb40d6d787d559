using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>An effect that throws or gives NaN is named, as in a simulation, with the body on which it acted.</summary>
public sealed class BatchEffectTests
{
    private static readonly string[] RuleNames = [.. Rules.All.Select(rule => rule.Name)];
    private static readonly TimeSteps Steps = TimeSteps.Every(0.02);

    [Test]
    public void Effect_that_breaks_by_time_is_named_and_no_body_has_made_that_step(
        [ValueSource(nameof(RuleNames))] string rule, [Values(true, false)] bool throws, [Values(1, 3)] int threads)
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }
            .With(Torque.Constant(new Vector3d(0.1, 0, 0)), 0, 0.3).With(new AtTime(throws, 0.5));
        Simulation simulation = new(Steps, body);
        BrokenEffectException alone = Assert.Throws<BrokenEffectException>(() => simulation.Step(100))!;
        // integrators that also evaluate at the end of a step fail one step earlier
        long step = simulation.StepsDone;
        Assert.That(step, Is.InRange(24, 25));
        BodyState[] starts = Crowding.Starts(1300, 1, body), states = new BodyState[1300];
        foreach (int count in new[] { 1, 7, 100 })
        {
            Together batch = new(body, Steps) { Threads = threads };
            foreach (BodyState start in starts)
                batch.Add(start);

            BrokenEffectException broken = Broken(batch, count);
            Assert.That((broken.Body, broken.Number, broken.Time, broken.Reason), Is.EqualTo(("b", 0, alone.Time, alone.Reason)));
            Assert.That((broken.Effect, broken.Entry, broken.InnerException?.Message), Is.EqualTo((alone.Effect, alone.Entry, alone.InnerException?.Message)));
            Assert.That(broken.Message, Is.EqualTo(alone.Message.Replace("body \"b\":", "body \"b\" 0:")));
            // an exception stops at once; a NaN is found when states are tested, and then all go back to where the call began
            Assert.That(batch.StepsDone, Is.EqualTo(throws || count >= 64 ? step : 63 / count * count));
            if (!throws && count < 64)
                continue;

            batch.Read(states);
            BodyDescription one = body.Copy("alone", body.Mass);
            one.Start = starts[1034];
            Crowding.Same(states[1034], Scenery.Run(Steps, one, step), rule);
            Assert.That(() => batch.Step(), Throws.InstanceOf<BrokenEffectException>().With.Message.EqualTo(broken.Message));
        }
    }

    [Test]
    public void Effect_that_breaks_for_one_body_names_it_and_the_others_go_on_without([ValueSource(nameof(RuleNames))] string rule, [Values(1, 3)] int threads)
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new AtHeight(7.51));
        Together batch = new(body, Steps) { Threads = threads };
        for (int i = 0; i < 1500; i++)
            batch.Add(Start(i is 1000 or 1400 ? 7 : 1 + (i * 1e-4)));

        for (int round = 0; round < 2; round++)
        {
            BrokenEffectException broken = Broken(batch, 40);
            Assert.That(broken.Number, Is.EqualTo(round == 0 ? 1000 : 1400));
            Assert.That(broken.InnerException, Is.InstanceOf<InvalidOperationException>());
            Assert.That(broken.Time, Is.EqualTo(0.51).Within(0.011)); // y = 7 + t
            Assert.That(batch.StepsDone, Is.InRange(25, 26));
            batch.Remove(broken.Number);
        }

        batch.Step(100);
        BodyDescription one = body.Copy("alone", body.Mass);
        one.Start = Start(1 + (77 * 1e-4));
        Crowding.Same(batch[77], Scenery.Run(Steps, one, batch.StepsDone), "77");

        static BodyState Start(double y) => new(new Vector3d(0, y, 0), Quaterniond.Identity, new Vector3d(0, 1, 0), new Vector3d(0.1, 0.2, 0.3));
    }

    [Test]
    public void Way_back_does_not_ask_what_the_program_pushed_with_before([Values("Exact", "RungeKutta4", "LabEuler")] string rule)
    {
        LabKeyboard keyboard = new();
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new AtTime(true, 0.5)).With(new HeldKeys(keyboard));
        Together batch = new(body, Steps);
        Simulation alone = new(Steps, body);
        batch.Add(body.Start);
        for (int i = 0; i < 6; i++)
        {
            keyboard[LabKey.RightArrow] = i % 2 == 0;
            try
            {
                batch.Step(5);
                alone.Step(5);
            }
            catch (BrokenEffectException)
            {
                break;
            }
        }

        Assert.That(() => alone.Step(5), Throws.InstanceOf<BrokenEffectException>());
        Assert.That(batch.StepsDone, Is.EqualTo(alone.StepsDone));
        Crowding.Same(batch[0], alone.Bodies[0].State, rule);
    }

    private static BrokenEffectException Broken(Together batch, int count) => Assert.Throws<BrokenEffectException>(() =>
    {
        while (batch.StepsDone < 10_000)
            batch.Step(count);
    })!;

    /// <summary>Breaks at a time.</summary>
    private readonly record struct AtTime(bool Throws, double From) : IPush
    {
        public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.Time >= From - 1e-9)
                impulse.Torque += Throws ? throw new TimeoutException("too late") : new Vector3d(0, double.NaN, 0);
        }
    }

    /// <summary>Throws for bodies beyond a height.</summary>
    private readonly record struct AtHeight(double Height) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (body.Position.Y > Height)
                throw new InvalidOperationException("too high");
        }
    }
}
