using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies that run away among many are named by number and step, and the others go on.</summary>
public sealed class BatchOverflowTests
{
    private static readonly string[] RuleNames = [.. Rules.All.Select(rule => rule.Name)];

    [TestCaseSource(nameof(RuleNames))]
    public void Body_that_runs_away_is_named_and_the_others_go_on(string rule)
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new Runaway(7.5, 1e300));
        foreach (int count in new[] { 1, 5, 64 })
        {
            Batch batch = new(body, TimeSteps.Every(0.02)) { Threads = 2 };
            for (int i = 0; i < 2100; i++)
                batch.Add(Start(i == 1500 ? 8 : 1 + (i * 1e-4)));

            StateOverflowException error = Assert.Throws<StateOverflowException>(() =>
            {
                while (batch.StepsDone < 200)
                    batch.Step(count);
            })!;
            Assert.That((error.Body, error.Number, error.Step), Is.EqualTo(("b", 1500, 63L)));
            Assert.That(error.Message, Does.StartWith($"body \"b\" 1500: {rule} has run away: no finite state at t = 1.28 s, after step 63"));
            Assert.That(batch.StepsDone, Is.EqualTo((63 / count * count) + count));
            Assert.That(() => batch[1500], Throws.InstanceOf<StateOverflowException>());
            BodyState[] states = new BodyState[batch.EndOfIds];
            Assert.That(() => batch.Read(states), Throws.InstanceOf<StateOverflowException>());

            batch.Remove(1500);
            batch.Step(3);
            batch.Read(states);
            long done = batch.StepsDone;
            BodyDescription alone = body.Copy("alone", body.Mass);
            alone.Start = Start(1 + (77 * 1e-4));
            Crowding.Same(states[77], Scenery.Run(TimeSteps.Every(0.02), alone, done), "77");
        }

        static BodyState Start(double y) => new(new Vector3d(0, y, 0), Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0.1, 0.2, 0.3));
    }

    [TestCase("Exact", 3)]
    [TestCase("LabEuler", 3)]
    [TestCase("RungeKutta4", 3)]
    [TestCase("UnityRigidbody", 3)]
    public void It_is_named_at_the_first_look_whoever_steps_how(string rule, int threads)
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }
            .With(new Force(new Vector3d(0, 1e300, 0)), 0.5);
        StateOverflowException expected = Assert.Throws<StateOverflowException>(() => new Simulation(TimeSteps.Every(0.02), body).Step(200))!;
        foreach (int count in new[] { 1, 7, 200 })
        {
            Batch batch = new(body, TimeSteps.Every(0.02)) { Threads = threads };
            foreach (BodyState start in Crowding.Starts(2000, 1, body))
                batch.Add(start);

            StateOverflowException found = Assert.Throws<StateOverflowException>(() =>
            {
                while (batch.StepsDone < 200)
                    batch.Step(count);
            })!;
            Assert.That(expected.Step, Is.EqualTo(25));
            Assert.That((found.Step, found.Time), Is.EqualTo((63L, 64 * 0.02)));
            Assert.That(found.Number, Is.Zero);
        }
    }

    [TestCaseSource(nameof(RuleNames))]
    public void Effect_that_gives_no_number_is_named(string rule)
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new Nan(), 0.5);
        Batch batch = new(body, TimeSteps.Every(0.02));
        foreach (BodyState start in Crowding.Starts(20, 1, body))
            batch.Add(start);

        Assert.That(
            () => batch.Step(100),
            Throws.InstanceOf<BrokenEffectException>().With.Message.StartsWith("body \"b\": effects[0]: must push with a finite force and torque, and did not at t = 0.5 s, in step 25"));
    }

    [Test]
    public void Body_that_coasts_away_is_named_when_somebody_looks()
    {
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()).With(new Gravity(new Vector3d(0, 1e153, 0)));
        Batch batch = new(body, TimeSteps.Every(1));
        foreach (BodyState start in Crowding.Starts(20, 1, body))
            batch.Add(start);

        batch.Step(5);
        Assert.That(batch[3].IsFinite);
        batch.Step(1000);
        Assert.That(() => batch[3], Throws.InstanceOf<StateOverflowException>());
        Assert.That(() => batch.Read(new BodyState[20]), Throws.InstanceOf<StateOverflowException>());
    }

    /// <summary>Strikes bodies beyond a height.</summary>
    private readonly record struct Runaway(double Height, double Size) : IPush
    {
        public PushTraits Traits => PushTraits.Moves | PushTraits.ReadsPosition;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += new Vector3d(body.Position.Y > Height ? duration * Size : 0, 0, 0);
    }

    private readonly struct Nan : IPush
    {
        public PushTraits Traits => PushTraits.Turns | PushTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Torque += new Vector3d(0, double.NaN, 0);
    }
}
