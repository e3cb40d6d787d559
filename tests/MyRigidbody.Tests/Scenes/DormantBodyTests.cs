using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A state that is not computed until it is read is the one that steps would give.</summary>
public sealed class DormantBodyTests
{
    private const long Steps = 1000;

    private static IEnumerable<object[]> Cases =>
        from integrator in Scenery.Integrators
        from moments in new[] { new Vector3d(1, 2, 2.5), new Vector3d(2, 2, 1), new Vector3d(2, 2, 2) }
        select new object[] { integrator, moments };

    [TestCaseSource(nameof(Cases))]
    public void Bits_do_not_depend_on_when_the_state_was_read(string integrator, Vector3d moments)
    {
        foreach (TimeSteps steps in Divisions())
        {
            Simulation always = Built(), rarely = Built(), never = Built();
            Random random = new(1);
            long next = 0;
            never.Step(Steps);
            for (long n = 1; n <= Steps; n++)
            {
                always.Step();
                BodyState seen = always.Bodies[0].State;
                if (n < next && n < Steps)
                    continue;

                rarely.Step(n - rarely.StepsDone);
                Assert.That(rarely.Bodies[0].State, Is.EqualTo(seen), $"step {n}");
                next = n + random.Next(1, 300);
            }

            Assert.That(never.Bodies[0].State, Is.EqualTo(always.Bodies[0].State));

            Simulation Built() => new(steps, Coaster(integrator, moments));
        }
    }

    [TestCaseSource(nameof(Cases))]
    public void Coasting_body_is_where_its_steps_lead(string integrator, Vector3d moments)
    {
        foreach (TimeSteps steps in Divisions())
        {
            Simulation coasting = new(steps, Coaster(integrator, moments)), stepped = Scenery.Stepped(steps, Coaster(integrator, moments));
            coasting.Step(Steps);
            stepped.Step(Steps);
            BodyState a = coasting.Bodies[0].State, b = stepped.Bodies[0].State;
            double apart = new[]
            {
                Conserved.AngleBetween(a.Orientation, b.Orientation),
                Samples.Apart(a.Position, b.Position) / b.Position.Length,
                Samples.Apart(a.Velocity, b.Velocity) / b.Velocity.Length,
                Samples.Apart(a.AngularVelocity, b.AngularVelocity) / b.AngularVelocity.Length,
            }.Max();
            TestContext.Out.WriteLine(FormattableString.Invariant($"{apart:g2}"));
            if (integrator.StartsWith("Exact", StringComparison.Ordinal))
                Assert.That(apart, Is.LessThan(1e-13)); // measured 1.5e-14
            else
                Assert.That(a, Is.EqualTo(b));
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void What_a_body_never_does_is_left_out_and_nothing_else_changes(string integrator)
    {
        BodyDescription Falls() => At(integrator, new Vector3d(1, 2, 3), Vector3d.Zero).With(new Gravity(new Vector3d(0, -9.81, 0))).With(new KeyPush(LabKey.RightArrow), 1, 2);
        BodyDescription Turns() => At(integrator, Vector3d.Zero, new Vector3d(0.3, 1.1, -0.7)).With(new KeyPush(LabKey.R), 1, 2);
        BodyDescription Lies() => At(integrator, Vector3d.Zero, Vector3d.Zero);
        foreach ((Func<BodyDescription> body, Omissions expected) in new (Func<BodyDescription>, Omissions)[]
            { (Falls, Omissions.Rotation), (Turns, Omissions.Translation), (Lies, Omissions.Rotation | Omissions.Translation) })
        {
            Simulation less = new(new SceneDescription("less", string.Empty, TimeSteps.Every(0.02), [body()]), Omissions.Rotation | Omissions.Translation);
            Simulation all = Scenery.Stepped(TimeSteps.Every(0.02), body());
            Assert.That(less.Bodies[0].Plan.LeftOut, Is.EqualTo(expected));
            Assert.That(all.Bodies[0].Plan.LeftOut, Is.EqualTo(Omissions.None));
            for (int n = 0; n < 200; n++)
            {
                less.Step();
                all.Step();
                Assert.That(less.Bodies[0].State, Is.EqualTo(all.Bodies[0].State));
            }
        }
    }

    [TestCase("LabEuler")]
    [TestCase("RungeKutta4")]
    [TestCase("ImplicitGyroscopic")]
    [TestCase("Exact")]
    [TestCase("Exact6")]
    public void Body_at_rest_sleeps_until_something_wakes_it(string integrator)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), At(integrator, Vector3d.Zero, Vector3d.Zero).With(new KeyPush(LabKey.RightArrow), 1, 2));
        // its rotation alone is left out for ever: it will be pushed, so it may move
        Assert.That(simulation.Bodies[0].Plan.LeftOut, Is.EqualTo(Omissions.Rotation));
        simulation.Step(50);
        Assert.That(simulation.Bodies[0].State.Velocity, Is.EqualTo(Vector3d.Zero));
        simulation.Step();
        Assert.That(simulation.Bodies[0].IsDormant, Is.False);
        Assert.That(simulation.Bodies[0].State.Velocity.X, Is.GreaterThan(0));
        Simulation lying = new(TimeSteps.Every(0.02), At(integrator, Vector3d.Zero, Vector3d.Zero));
        Assert.That(lying.Bodies[0].IsDormant, Is.True);
    }

    [Test]
    public void Unity_s_body_is_not_stepped_while_it_sleeps()
    {
        TimeSteps steps = TimeSteps.Every(0.02);
        BodyDescription Body() => At("UnityRigidbody", new Vector3d(0.01, 0, 0), Vector3d.Zero).With(new KeyPush(LabKey.RightArrow), 3, 3.1);
        Simulation simulation = new(steps, Body()), all = Scenery.Stepped(steps, Body());
        int dormant = 0;
        for (int n = 0; n < 400; n++)
        {
            simulation.Step();
            all.Step();
            Assert.That(simulation.Bodies[0].State, Is.EqualTo(all.Bodies[0].State));
            Assert.That(simulation.Bodies[0].IsAsleep, Is.EqualTo(all.Bodies[0].IsAsleep));
            dormant += simulation.Bodies[0].IsDormant ? 1 : 0;
        }

        // asleep after 0.4 s at the latest, until 3 s, and not again: the push leaves 0.5 m/s
        Assert.That(dormant, Is.InRange(125, 149));
    }

    [Test]
    public void Many_bodies_wake_each_at_its_own_time()
    {
        Random random = new(7);
        BodyDescription[] bodies = [.. Enumerable.Range(0, 200).Select(i =>
        {
            double from = random.NextDouble() * 10;
            return At(i % 3 == 0 ? "LabEuler" : "Exact", Vector3d.Zero, new Vector3d(0, 0, i % 5), "body " + i)
                .With(new KeyPush(LabKey.UpArrow), from, from + 0.1 + random.NextDouble());
        })];
        TimeSteps steps = TimeSteps.Every(0.02);
        Simulation together = new(steps, bodies), inPieces = new(steps, bodies);
        together.Step(600);
        while (inPieces.StepsDone < 600)
            inPieces.Step(Math.Min(random.Next(1, 20), 600 - inPieces.StepsDone));

        for (int i = 0; i < bodies.Length; i++)
        {
            BodyState alone = Scenery.Run(steps, bodies[i], 600);
            Assert.That(together.Bodies[i].State, Is.EqualTo(alone), bodies[i].Name);
            Assert.That(inPieces.Bodies[i].State, Is.EqualTo(alone), bodies[i].Name);
            Assert.That(alone.Velocity.Y, Is.GreaterThan(0));
        }
    }

    private static IEnumerable<TimeSteps> Divisions()
    {
        yield return TimeSteps.Every(1.0 / 60, Steps);
        yield return TimeSteps.Of([.. Enumerable.Range(0, (int)Steps).Select(n => new[] { 0.005, 0.02, 0.025 }[n % 3])]);
    }

    private static BodyDescription Coaster(string integrator, Vector3d moments)
    {
        BodyDescription like = Scenery.Body(integrator);
        return like.Copy("coaster", MassProperties.FromPrincipal(2, moments, new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3)))
            .With(new Gravity(new Vector3d(0, -9.81, 0)), 0, 9)
            .With(new LinearDamping(0.3), 2)
            .With(new AngularDamping(0.02), 2)
            .With(new KeyPush(LabKey.UpArrow), 4, 4.5);
    }

    private static BodyDescription At(string integrator, Vector3d velocity, Vector3d spin, string name = "body")
    {
        BodyDescription like = Scenery.Body(integrator);
        return new BodyDescription(name, Solids.Box(1, new Vector3d(1, 2, 3)))
        {
            Rule = like.Rule,
            Unity = like.Unity,
            Start = new BodyState(new Vector3d(1, 2, 3), Pushes.State.Orientation, velocity, spin),
        };
    }
}
