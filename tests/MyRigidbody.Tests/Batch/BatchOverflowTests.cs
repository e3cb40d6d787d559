using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Of many bodies the one that diverges is named, with its step; all are then before that step, and the others can go on.</summary>
public sealed class BatchOverflowTests
{
    // the largest velocity whose square is a number
    private static readonly double Largest = Math.Sqrt(double.MaxValue);
    private static readonly string[] RuleNames = [.. Rules.All.Select(rule => rule.Name)];
    private static readonly TimeSteps Steps = TimeSteps.Every(0.02);
    // under a constant force alone bodies coast, and their states are not tested
    private static readonly Torque Awake = Torque.Constant(new Vector3d(1e-3, 0, 0));

    [TestCaseSource(nameof(RuleNames))]
    public void Body_that_diverges_is_named_and_the_others_go_on(string rule)
    {
        // the one that starts at 7 m with 1 m/s is struck in the first step that begins above 7.51 m
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new Runaway(7.51, 1e300));
        StateOverflowException alone = Assert.Throws<StateOverflowException>(() => new Simulation(Steps, Alone(body, Start(7))).Step(200))!;
        Assert.That(alone.Step, Is.InRange(25, 26)); // 25.5 steps of 0.02 m, asked at the beginning of a step or after it
        foreach (int count in new[] { 1, 5, 64, 200 })
        {
            Together batch = new(body, Steps) { Threads = 2 };
            for (int i = 0; i < 2100; i++)
                batch.Add(Start(i == 1500 ? 7 : 1 + (i * 1e-4)));

            StateOverflowException error = Lost(batch, count);
            Assert.That((error.Body, error.Number, error.Step), Is.EqualTo(("b", 1500, alone.Step)));
            Assert.That(error.Message, Does.StartWith($"body \"b\" 1500: {rule} has diverged: no finite state at t = {(alone.Step + 1) * 0.02} s, after step {alone.Step}"));
            // states are not tested after every call of less than 64 steps: so the beginning of the call that ends with step 64, or the step itself
            Assert.That(batch.StepsDone, Is.EqualTo(Math.Max(alone.Step, (count < 64 ? 63 : 0) / count * count)));

            batch.Remove(1500);
            batch.Step(3);
            BodyState[] states = new BodyState[batch.EndOfIds];
            batch.Read(states);
            Crowding.Same(states[77], Scenery.Run(Steps, Alone(body, Start(1 + (77 * 1e-4))), batch.StepsDone), "77");
        }

        static BodyState Start(double y) => new(new Vector3d(0, y, 0), Quaterniond.Identity, new Vector3d(0, 1, 0), new Vector3d(0.1, 0.2, 0.3));
    }

    [TestCase("LabEuler", 1.0)]
    [TestCase("RungeKutta4", 1.0)]
    [TestCase("Exact", 1.0)]
    [TestCase("LabEuler", 0.3)]
    public void Step_is_that_in_which_the_square_of_the_velocity_outgrows_a_double(string rule, double strength)
    {
        // v' = k v: each integrator multiplies v by its own function of z = k h in every step
        double z = 30 * strength * 0.02, growth = rule switch
        {
            "LabEuler" => 1 + z,
            "RungeKutta4" => 1 + z + (z * z / 2) + (z * z * z / 6) + (z * z * z * z / 24),
            _ => Math.Exp(z),
        };
        long expected = (long)Math.Ceiling(Math.Log(Largest / 3) / Math.Log(growth)) - 1; // 741, 591, 591; 2137
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new Feeding(30 * strength));
        foreach (int count in new[] { 1, 50, 3000 })
        {
            Together batch = new(body, Steps);
            for (int i = 0; i < 40; i++)
                batch.Add(new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(i == 33 ? 3 : 1e-30, 0, 0), Vector3d.Zero));

            StateOverflowException error = Lost(batch, count);
            Assert.That((error.Number, error.Step, error.Time), Is.EqualTo((33, expected, Steps.StartOf(expected + 1))));
            Assert.That(batch.StepsDone, Is.InRange(expected, expected + 63));
        }
    }

    [TestCase("Exact")]
    [TestCase("Exact6")]
    [TestCase("LabEuler")]
    public void Step_is_that_in_which_a_constant_force_has_given_too_much(string rule)
    {
        // pushes that read nothing go in lanes; n steps from the 10th on give n h F / m, after five windows of other forces, of 225 steps
        int most = Search.Count(1500, 300);
        double gain = Largest / (most + 0.5) / 0.02;
        BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(2, new Vector3d(1, 2, 3))) { Rule = Rules.Named(rule) }
            .With(new Force(new Vector3d(0, 2 * gain, 0)), 0.2).With(Awake);
        for (int i = 0; i < 5; i++)
            body.With(new Force(new Vector3d(1, 0, 0)), 0.1 + i, 0.5 + i);

        foreach (int count in new[] { 1, 7, 2000 })
        {
            Together batch = new(body, Steps) { Threads = 3 };
            foreach (BodyState start in Crowding.Starts(2500, 1, body))
                batch.Add(start);

            StateOverflowException error = Lost(batch, count);
            Assert.That((error.Number, error.Step), Is.EqualTo((0, 10L + most)));
        }
    }

    [TestCase("Exact4", false)]
    [TestCase("LabEuler", false)]
    [TestCase("RungeKutta4", false)]
    [TestCase("Exact4", true)]
    public void They_are_named_one_after_another_while_bodies_come_and_go(string rule, bool isSteered)
    {
        // sums of this length are exact, so that time may begin anywhere; a body that starts with (½ − j) g is lost after 200 + j steps of g each
        TimeSteps steps = TimeSteps.Every(1 / 64.0);
        double g = Largest / 200;
        BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { Rule = Rules.Named(rule) }
            .With(new Force(new Vector3d(0, 64 * g, 0))).With(Awake);
        if (isSteered)
            body.With(new HeldKeys(new LabKeyboard()));

        Together batch = new(body, steps);
        Random random = new(5);
        Dictionary<int, long> lostAfter = [];
        BodyState stays = Start(150);
        int named = 0, staying = -1;
        while (named < 40)
        {
            while (lostAfter.Count < 37)
            {
                int j = random.Next(90);
                int id = batch.Add(Start(j));
                lostAfter.Add(id, batch.StepsDone + 199 + j);
            }

            if (named == 30 && staying < 0)
            {
                staying = batch.Add(stays);
                lostAfter.Add(staying, batch.StepsDone + 349);
            }

            long began = batch.StepsDone;
            try
            {
                batch.Step(random.Next(1, random.Next(2, 150)));
                if (random.Next(10) == 0)
                {
                    int leaving = lostAfter.Keys.Where(id => id != staying && lostAfter[id] >= batch.StepsDone).ElementAt(random.Next(5));
                    batch.Remove(leaving);
                    lostAfter.Remove(leaving);
                }
            }
            catch (StateOverflowException lost)
            {
                named++;
                Assert.That(lost.Step, Is.EqualTo(lostAfter.Values.Min()));
                int id = batch.IdOf(lost.Handle!);
                Assert.That(lostAfter[id], Is.EqualTo(lost.Step));
                Assert.That(batch.StepsDone, Is.EqualTo(Math.Max(began, lost.Step)));
                batch.Remove(id);
                lostAfter.Remove(id);
            }
        }

        long since = lostAfter[staying] - 349;
        Crowding.Same(batch[staying], Scenery.Run(steps, Alone(body, stays), batch.StepsDone - since), "who stays");

        BodyState Start(int j) => new(Vector3d.Zero, Quaterniond.Identity, new Vector3d(0, (0.5 - j) * g, 0), new Vector3d(1, 2, 3));
    }

    [TestCase("Exact")]
    [TestCase("RungeKutta4")]
    [TestCase("LabEuler")]
    public void Reading_a_lost_body_names_its_step_and_moves_no_other(string rule)
    {
        double g = Largest / 20;
        BodyDescription body = new BodyDescription("b", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { Rule = Rules.Named(rule) }
            .With(new Force(new Vector3d(50 * g, 0, 0))).With(Awake);
        Together batch = new(body, Steps);
        for (int i = 0; i < 7; i++)
            batch.Add(new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d((0.5 - (i == 4 ? 0 : 15)) * g, 0, 0), Vector3d.Zero));

        for (int i = 0; i < 30; i++)
            batch.Step();

        BodyState before = batch[5];
        BodyState[] states = new BodyState[7];
        Assert.That(() => batch[4], Throws.InstanceOf<StateOverflowException>().With.Property("Step").EqualTo(19).And.Property("Number").EqualTo(4));
        Assert.That(() => batch.Read(states), Throws.InstanceOf<StateOverflowException>().With.Property("Step").EqualTo(19).And.Property("Number").EqualTo(4));
        Assert.That(states, Is.All.EqualTo(default(BodyState)));
        Assert.That(batch.StepsDone, Is.EqualTo(30));
        Crowding.Same(batch[5], before, "another");
        batch.Remove(4);
        batch.Read(states);
        Crowding.Same(states[5], before, "another");
    }

    [TestCase(16)]
    [TestCase(1)]
    public void Body_that_coasts_away_is_named_with_the_step_that_it_has_alone(int threads)
    {
        // v = 3e152 t m/s fills a double's square at 44.7 s; a push that begins at 2000 s wakes them all
        BodyDescription body = new BodyDescription("b", Crowding.Masses.First())
            .With(new Gravity(new Vector3d(0, 3e152, 0))).With(Torque.Constant(new Vector3d(0, 1, 0)), 2000);
        StateOverflowException alone = Assert.Throws<StateOverflowException>(() => new Simulation(TimeSteps.Every(1), body).Step(3000))!;
        Assert.That(alone.Step, Is.EqualTo(44));
        Together batch = new(body, TimeSteps.Every(1)) { Threads = threads };
        foreach (BodyState start in Crowding.Starts(20, 1, body))
            batch.Add(start);

        batch.Step(30);
        int late = batch.Add(BodyState.AtRest);
        BodyState before = batch[3];
        Assert.That(() => batch.Step(3000), Throws.InstanceOf<StateOverflowException>().With.Property("Step").EqualTo(44).And.Property("Number").EqualTo(0));
        Assert.That(batch.StepsDone, Is.EqualTo(44));
        batch.Step(20);
        Assert.That(() => batch[3], Throws.InstanceOf<StateOverflowException>().With.Property("Step").EqualTo(44).And.Property("Number").EqualTo(3));
        Assert.That(() => batch.Read(new BodyState[21]), Throws.InstanceOf<StateOverflowException>().With.Property("Step").EqualTo(44).And.Property("Number").EqualTo(0));
        for (int i = 0; i < late; i++)
            batch.Remove(i);

        Assert.That(batch[late].Velocity.Y, Is.EqualTo(34 * 3e152).Within(1).Ulps);
        StateOverflowException last = Assert.Throws<StateOverflowException>(() => batch.Step(3000))!;
        Assert.That((last.Step, batch.IdOf(last.Handle!)), Is.EqualTo((74L, late)));
        Assert.That(before.IsFinite);
    }

    private static StateOverflowException Lost(Together batch, int count) => Assert.Throws<StateOverflowException>(() =>
    {
        while (batch.StepsDone < 10_000)
            batch.Step(count);
    })!;

    private static BodyDescription Alone(BodyDescription body, BodyState start)
    {
        BodyDescription alone = body.Copy("alone", body.Mass);
        alone.Start = start;
        return alone;
    }

    /// <summary>Strikes bodies beyond a height.</summary>
    private readonly record struct Runaway(double Height, double Size) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += new Vector3d(body.Position.Y > Height ? duration * Size : 0, 0, 0);
    }

    /// <summary>v' = k v.</summary>
    private readonly record struct Feeding(double Rate) : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsVelocity;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            wrench.Force += mass.Mass * Rate * body.Velocity;

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += (Math.Exp(Rate * duration) - 1) * ((mass.Mass * body.Velocity) + impulse.Force);
    }
}
