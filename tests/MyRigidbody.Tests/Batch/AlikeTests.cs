using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies with separate but equal descriptions are moved together once they are many, to the same bits.</summary>
public sealed class AlikeTests
{
    // this many bodies are moved alone
    private const int First = 64;

    // sums of this length are exact, so that time may begin anywhere
    private static readonly TimeSteps Steps = TimeSteps.Every(1 / 64.0);

    private static readonly Dictionary<string, Func<string, BodyDescription>> Described = new()
    {
        ["free"] = name => new BodyDescription(name, Tilted()),
        ["falls"] = name => new BodyDescription(name, Tilted()).With(new Gravity(new Vector3d(0.1, -9.81, 0))).With(new AngularDamping(0.1)),
        ["turned"] = name => new BodyDescription(name, Tilted()).With(Torque.Constant(new Vector3d(0.1, 0.2, -0.1)), 0, 2),
        ["sprung"] = name => new BodyDescription(name, Tilted()).With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4)),
        ["lab"] = name => new BodyDescription(name, Tilted()) { Rule = Rules.LabEuler }.With(new DecayPerStep(0.98, 0.98)).With(new KeyPush(LabKey.R)),
        ["engine"] = name => new BodyDescription(name, Tilted()) { Rule = Rules.Named("UnityRigidbody") },
    };

    [Test]
    public void Each_moves_as_it_would_alone_whatever_is_done_with_it([ValueSource(nameof(Names))] string kind)
    {
        Random random = new(kind.Length);
        Simulation many = new(Steps) { Threads = 2 };
        BodyState[] starts = Crowding.Starts(150, 7, Described[kind]("any"));
        List<(Body One, Simulation Alone, Body Same)> bodies = [];
        foreach (BodyState start in starts)
        {
            BodyDescription body = Described[kind]("body " + bodies.Count);
            body.Start = start;
            Simulation alone = new(Steps);
            bodies.Add((many.Add(body), alone, alone.Add(body)));
        }

        Assert.That(many.Bodies.Select(body => body.Mover.HasMany), Is.EqualTo(starts.Select((_, i) => i >= First)));
        SavedSimulation saved = many.Save();
        SavedSimulation[] each = [.. bodies.Select(body => body.Alone.Save())];
        Live();
        Assert.That(many.Bodies, Has.Some.Matches<Body>(body => body.Mover.HasMany).And.Some.Matches<Body>(body => !body.Mover.HasMany));
        many.Restore(saved);
        for (int i = 0; i < bodies.Count; i++)
            bodies[i].Alone.Restore(each[i]);

        CheckAll("restored");
        Live();

        void Live()
        {
            for (int i = 0; i < 200; i++)
            {
                int some = random.Next(bodies.Count), what = random.Next(9), seed = random.Next();
                Do(what, seed, bodies[some].One);
                Do(what, seed, bodies[some].Same);
                Check(some, $"{i}, {what}");
                int count = i % 50 == 49 ? 300 : random.Next(3);
                many.Step(count);
                foreach ((_, Simulation alone, _) in bodies)
                    alone.Step(count);
            }

            CheckAll("end");
        }

        void CheckAll(string when)
        {
            BodyState[] read = new BodyState[many.Bodies.Count];
            many.ReadStates(read);
            for (int i = 0; i < bodies.Count; i++)
            {
                Check(i, when);
                if (!bodies[i].One.IsRemoved)
                    Crowding.Same(read[bodies[i].One.Index], bodies[i].Same.State, "read");
            }
        }

        void Check(int number, string when)
        {
            (Body one, _, Body same) = bodies[number];
            Assert.That((one.Name, one.IsRemoved), Is.EqualTo((same.Name, same.IsRemoved)), when);
            if (!one.IsRemoved)
                Crowding.Same(one.State, same.State, $"{one.Name} at {when}");
        }

        void Do(int what, int seed, Body body)
        {
            Random own = new(seed);
            Vector3d a = Any(), b = Any();
            if (body.IsRemoved)
            {
                body.Simulation.Add(body, starts[own.Next(starts.Length)]);
                return;
            }

            switch (what)
            {
                case 0: body.ApplyForce(a); break;
                case 1: body.ApplyTorque(a, inBody: true); break;
                case 2: body.ApplyImpulse(a, b); break;
                case 3: body.State = starts[own.Next(starts.Length)]; break;
                case 4: body.Change(Described["lab"]("other " + body.Name)); break;
                case 5: body.Simulation.Remove(body); break;
                case 6: _ = body.Between(0.5); break;
                case 7: body.Change(Described[kind](body.Name), Keeping.Momentum); break;
                default: _ = body.AngularMomentum; break;
            }

            Vector3d Any() => new(own.NextDouble() - 0.5, own.NextDouble() - 0.5, own.NextDouble() - 0.5);
        }
    }

    private static IEnumerable<TestCaseData> Others()
    {
        MassProperties tilted = Tilted();
        yield return Other("the last digit of the mass", MassProperties.FromPrincipal(Math.BitIncrement(tilted.Mass), tilted.PrincipalMoments, tilted.PrincipalFrame, tilted.CenterOfMass));
        yield return Other("the sign of a zero", MassProperties.FromPrincipal(tilted.Mass, tilted.PrincipalMoments, tilted.PrincipalFrame, -1 * tilted.CenterOfMass));
        yield return Other("a rule", tilted, body => body.Rule = Rules.Exact4);
        yield return Other("a lock", tilted, body => body.Lock = Locks.MoveX);
        yield return Other("a setting of the lab", tilted, body => body.Lab.Normalise = false);
        yield return Other("a setting of the engine", tilted, body => body.Unity.Drag = 0.1);
        yield return Other("an effect more", tilted, body => body.With(new LinearDamping(0.1)));
        yield return Other("a window", tilted, body => body.Without(_ => true).With(new Gravity(new Vector3d(0, -9.81, 0)), 0, 5));
        yield return Other("a number of an effect", tilted, body => body.Without(_ => true).With(new Gravity(new Vector3d(0, -9.82, 0))));

        static TestCaseData Other(string what, MassProperties mass, Action<BodyDescription>? change = null)
        {
            BodyDescription other = new BodyDescription("other", mass).With(new Gravity(new Vector3d(0, -9.81, 0)));
            change?.Invoke(other);
            return new TestCaseData(other).SetArgDisplayNames(what);
        }
    }

    [TestCaseSource(nameof(Others))]
    public void Body_that_is_described_otherwise_is_none_of_them(BodyDescription other)
    {
        Simulation many = new(Steps);
        for (int i = 0; i <= First; i++)
            many.Add(new BodyDescription("body", Tilted()).With(new Gravity(new Vector3d(0, -9.81, 0))));

        Assert.That(many.Add(new BodyDescription("same", Tilted()).With(new Gravity(new Vector3d(0, -9.81, 0)))).Mover.HasMany);
        Assert.That(many.Add(other).Mover.HasMany, Is.False);
    }

    [Test]
    public void What_somebody_else_wrote_or_steers_is_shared_only_where_he_says_so()
    {
        LabKeyboard keyboard = new();
        BodyDescription custom = new BodyDescription("custom", Tilted()).With(new Foreign()), steered = new BodyDescription("steered", Tilted()).With(new HeldKeys(keyboard));
        Simulation many = new(Steps);
        for (int i = 0; i < 2 * First; i++)
        {
            Assert.That(many.Add(custom.Copy("copy", custom.Mass)).Mover.HasMany, Is.False);
            Assert.That(many.Add(steered.Copy("copy", steered.Mass)).Mover.HasMany, Is.False);
        }

        many.Add(custom);
        Assert.That(many.Add(custom).Mover.HasMany);
    }

    [Test]
    public void One_that_runs_away_is_called_by_its_own_name()
    {
        Simulation many = new(Steps);
        for (int i = 0; i < 100; i++)
            many.Add(Described["lab"]("body " + i));

        Body lost = many.Bodies[90], left = many.Bodies[80];
        lost.State = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1e150, 0, 0));
        left.State = lost.State;
        _ = left.Between(1);
        Assert.That((lost.Mover.HasMany, left.Mover.HasMany), Is.EqualTo((true, false)));
        Assert.That(() => lost.ApplyForce(new Vector3d(double.MaxValue, 0, 0)), Throws.Nothing);
        Assert.That(() => lost.ApplyForce(new Vector3d(double.MaxValue, 0, 0)), Throws.TypeOf<OverflowException>().With.Message.StartsWith("body \"body 90\": "));
        many.Remove(left);
        Assert.That(() => many.Step(200), Throws.TypeOf<StateOverflowException>().With.Property("Handle").SameAs(lost).And.Property("Body").EqualTo("body 90").And.Message.StartsWith("body \"body 90\""));
    }

    [Test]
    public void Bodies_that_are_all_different_leave_nothing_behind()
    {
        Simulation many = new(Steps);
        for (int i = 0; i < 5000; i++)
            many.Remove(many.Add(new BodyDescription("body", MassProperties.FromPrincipal(1 + i, new Vector3d(1, 1, 1)))));

        for (int i = 0; i < 100; i++)
            many.Add(new BodyDescription("body", Tilted()));

        Assert.That(many.Bodies.Count(body => body.Mover.HasMany), Is.EqualTo(100 - First));
    }

    private static IEnumerable<string> Names => Described.Keys;

    // created anew for each body, as by a program that describes bodies one by one
    private static MassProperties Tilted() => MassProperties.FromPrincipal(2, new Vector3d(3, 1, 2.5), new Quaterniond(0.9, 0.1, -0.3, 0.2), Vector3d.Zero);

    private readonly struct Foreign : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => wrench.Force += new Vector3d(1, 0, 0);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => impulse.Force += new Vector3d(duration, 0, 0);
    }
}
