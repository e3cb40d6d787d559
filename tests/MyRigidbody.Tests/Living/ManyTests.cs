using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Many bodies in one simulation move, under any operations, as each would in a simulation of its own.</summary>
public sealed class ManyTests
{
    // sums of this length are exact, so that time may begin anywhere
    private static readonly TimeSteps Steps = TimeSteps.Every(1 / 64.0);

    /// <summary>Integrators, tops and effects of many kinds, some for a part of the time.</summary>
    private static BodyDescription[] Kinds() =>
    [
        new("free", Crowding.Masses.First()),
        new BodyDescription("falls", Crowding.Masses.ElementAt(1)).With(new Gravity(new Vector3d(0.1, -9.81, 0))).With(new LinearDamping(0.3)),
        new BodyDescription("turned", Crowding.Masses.ElementAt(4)).With(Torque.Constant(new Vector3d(0.1, 0.2, -0.1))),
        new BodyDescription("sprung", Crowding.Masses.ElementAt(5)).With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4)),
        new BodyDescription("woken", Crowding.Masses.ElementAt(6)).With(new AngularDamping(0.1)).With(new Force(new Vector3d(1, 0, 0)), 2, 3),
        new BodyDescription("lab", Crowding.Masses.First()) { Rule = Rules.LabEuler }.With(new DecayPerStep(0.98, 0.98)),
        new BodyDescription("fourth", Crowding.Masses.ElementAt(1)) { Rule = Rules.Named("Exact4") }.With(new KeyPush(LabKey.R), 1, 4),
        new BodyDescription("engine", Crowding.Masses.First()) { Rule = Rules.Named("UnityRigidbody") }.With(new Gravity(new Vector3d(0, -1, 0)), 1, 2),
        new BodyDescription("held", Crowding.Masses.ElementAt(5)) { CanMove = false, Rule = Rules.Named("RungeKutta4") },
    ];

    [Test]
    public void Each_moves_as_if_it_were_alone_whatever_is_done_with_it([Range(1, 8)] int seed)
    {
        Random random = new(seed);
        BodyDescription[] kinds = Kinds();
        Simulation together = new(Steps) { Threads = 2 };
        List<(Body One, Simulation Alone, Body Same)> bodies = [];
        List<(SavedSimulation All, List<(Body One, Simulation Alone, Body Same)> Bodies, SavedSimulation[] Each, int Calls)> saved = [];
        // a simulation that begins later goes through the same time: some steps of the common length, or one of another
        List<(long Count, double Length)> calls = [];
        for (int i = 0; i < 1500; i++)
        {
            int what = random.Next(20);
            if (bodies.Count < 100 || what < 3)
            {
                BodyDescription kind = kinds[random.Next(kinds.Length)];
                BodyState start = random.Next(4) == 0 ? BodyState.AtRest : Crowding.Starts(13, random.Next(), kind)[random.Next(13)];
                Simulation alone = new(Steps);
                foreach ((long count, double length) in calls)
                    Step(alone, count, length);

                bodies.Add((together.Add(kind, start), alone, alone.Add(kind, start)));
            }
            else if (what < 6)
            {
                long count = random.Next(1, random.Next(2, 40));
                StepAll(count, 0);
            }
            else if (what < 8)
            {
                int leaving = random.Next(bodies.Count);
                together.Remove(bodies[leaving].One);
                Assert.That(bodies[leaving].One.IsRemoved, Is.True);
                bodies.RemoveAt(leaving);
            }
            else if (what == 8)
            {
                double length = 1 / 64.0 + (random.Next(3) / 512.0);
                if (random.Next(10) > 0)
                    continue;

                StepAll(1, length);
            }
            else if (what == 9 && random.Next(10) == 0)
            {
                saved.Add((together.Save(), [.. bodies], [.. bodies.Select(body => body.Alone.Save())], calls.Count));
            }
            else if (what == 10 && saved.Count > 0 && random.Next(10) == 0)
            {
                (SavedSimulation All, List<(Body One, Simulation Alone, Body Same)> Bodies, SavedSimulation[] Each, int Calls) back = saved[random.Next(saved.Count)];
                together.Restore(back.All);
                calls.RemoveRange(back.Calls, calls.Count - back.Calls);
                saved.RemoveAll(other => other.Calls > back.Calls);
                bodies = [.. back.Bodies];
                for (int k = 0; k < bodies.Count; k++)
                    bodies[k].Alone.Restore(back.Each[k]);
            }
            else
            {
                int some = random.Next(bodies.Count);
                Do(what, random.Next(), bodies[some].One, bodies[some].Same);
                Check(some, i + " " + what);
            }
        }

        Assert.That(together.Bodies, Is.EquivalentTo(bodies.Select(body => body.One)));
        for (int i = 0; i < bodies.Count; i++)
            Check(i, "end");

        void StepAll(long count, double length)
        {
            calls.Add((count, length));
            Step(together, count, length);
            foreach ((_, Simulation alone, _) in bodies)
                Step(alone, count, length);
        }

        void Check(int number, string when)
        {
            (Body one, Simulation alone, Body same) = bodies[number];
            Assert.That(alone.StepsDone, Is.EqualTo(together.StepsDone));
            Crowding.Same(one.State, same.State, $"{one.Name} at {when}, step {together.StepsDone}");
        }
    }

    [Test]
    public void Removed_body_comes_back_by_its_handle_and_is_never_another()
    {
        Simulation simulation = new(Steps);
        BodyDescription kind = Kinds()[2];
        Body[] bodies = [.. Enumerable.Range(0, 20).Select(i => simulation.Add(kind, At(i)))];
        simulation.Step(3);
        simulation.Remove(bodies[7]);
        Assert.That(bodies[7].IsRemoved);
        Assert.That(() => bodies[7].State, Throws.InvalidOperationException);
        Assert.That(() => bodies[7].ApplyForce(Vector3d.Zero), Throws.InvalidOperationException);
        Body other = simulation.Add(kind, At(50));
        Assert.That(other, Is.Not.SameAs(bodies[7]));
        Assert.That(bodies.Where(body => body != bodies[7]).Select(body => body.State.Position.X), Is.EqualTo(Enumerable.Range(0, 20).Where(i => i != 7)));
        Assert.That(() => simulation.Add(bodies[8], At(0)), Throws.ArgumentException);
        Assert.That(() => new Simulation(Steps).Add(bodies[7], At(0)), Throws.ArgumentException);
        simulation.Add(bodies[7], At(70));
        Assert.That(bodies[7].State, Is.EqualTo(At(70)));
        Assert.That(simulation.Bodies, Has.Count.EqualTo(21).And.Member(bodies[7]));
        simulation.Step(5);
        Simulation alone = new(Steps);
        Body same = alone.Add(kind, At(70));
        alone.Step(5);
        Crowding.Same(bodies[7].State, same.State, "back");
        Crowding.Same(other.State, new BodyState(At(50).Position, same.State.Orientation, Vector3d.Zero, same.State.AngularVelocity), "other");

        static BodyState At(int x) => new(new Vector3d(x, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
    }

    [Test]
    public void Description_that_was_changed_is_another_kind()
    {
        BodyDescription kind = new("b", Crowding.Masses.First()) { Rule = Rules.LabEuler };
        BodyState start = new(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0, 0, 1));
        Simulation simulation = new(Steps);
        for (int i = 0; i < 3; i++)
            simulation.Add(kind, start);

        kind.With(new LinearDamping(1));
        Body damped = simulation.Add(kind, start);
        kind.Lab.Normalise = false;
        Body unscaled = simulation.Add(kind, start);
        simulation.Step(10);
        Assert.That(simulation.Bodies.Take(3).Select(body => body.State.Velocity.X), Is.All.EqualTo(1));
        Assert.That(damped.State.Velocity.X, Is.LessThan(0.9));
        Assert.That(damped.State.Orientation.Length, Is.EqualTo(1).Within(1e-15));
        Assert.That(unscaled.State.Orientation.Length, Is.GreaterThan(1.0002)); // each step by 1 + (ω h)²/8
    }

    [Test]
    public void Where_one_cannot_go_on_all_kinds_stand_before_that_step()
    {
        BodyDescription[] kinds = Kinds();
        Simulation simulation = new(Steps) { Threads = 2 };
        for (int i = 0; i < 200; i++)
            simulation.Add(kinds[i % kinds.Length], new BodyState(new Vector3d(i, 0, 0), Quaterniond.Identity, kinds[i % kinds.Length].CanMove ? new Vector3d(1, 0, 0) : Vector3d.Zero, new Vector3d(1, 2, 3)));

        Body breaks = simulation.Add(new BodyDescription("breaks", Crowding.Masses.First()).With(new Breaks()), new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(0, 1, 0), Vector3d.Zero));
        Body pushed = simulation.Bodies[120];
        SavedSimulation saved = simulation.Save();
        simulation.Step(20);
        pushed.ApplyForce(new Vector3d(1, 2, 3));
        simulation.Step(12);
        BodyState[] before = [.. simulation.Bodies.Select(body => body.State)];
        simulation.Restore(saved);
        simulation.Step(20);
        pushed.ApplyForce(new Vector3d(1, 2, 3));
        Assert.That(() => simulation.Step(1000), Throws.InstanceOf<BrokenEffectException>().With.Property("Body").EqualTo("breaks"));
        // after 32 steps y is 0.5 m, and in the next it is more
        Assert.That(simulation.StepsDone, Is.EqualTo(32));
        simulation.Remove(breaks);
        for (int i = 0; i < 200; i++)
            Crowding.Same(simulation.Bodies[i].State, before[i], simulation.Bodies[i].Name + i);

        Assert.That(() => simulation.Step(1000), Throws.Nothing);
    }

    [TestCase(0)]
    [TestCase(2)]
    [TestCase(3)]
    public void Coming_going_pushing_and_reading_one_of_many_allocates_nothing(int which)
    {
        BodyDescription kind = Kinds()[which];
        Simulation simulation = new(Steps) { Threads = 1 };
        Body[] bodies = [.. Crowding.Starts(3000, 1, kind).Select(start => simulation.Add(kind, start))];
        BodyState start = bodies[5].State;
        int next = 1;
        Live();
        // a collection that other tests cause adds what is left of the thread's own memory
        Assert.That(Enumerable.Range(0, 3).Min(_ => BytesOfLiving()), Is.Zero);

        long BytesOfLiving()
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            Live();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }

        void Live()
        {
            for (int i = 0; i < 50; i++)
            {
                Body body = bodies[next = 1 + ((next * 7919) % 2999)];
                simulation.Remove(body);
                simulation.Add(body, start);
                body.ApplyImpulse(new Vector3d(1, 2, 3), new Vector3d(0, 1, 0));
                body.ApplyForce(new Vector3d(1, 2, 3), inBody: true);
                body.State = start;
                start.Position = body.State.Position;
                simulation.Step();
            }
        }
    }

    private static void Step(Simulation simulation, long count, double length)
    {
        if (length > 0)
            simulation.StepBy(length);
        else
            simulation.Step(count);
    }

    private static void Do(int what, int seed, params Body[] bodies)
    {
        foreach (Body body in bodies)
        {
            Random random = new(seed);
            Vector3d push = Any(random), point = body.State.Position + (0.1 * Any(random));
            bool inBody = random.Next(2) == 0;
            switch (what)
            {
                case 11:
                    body.ApplyImpulse(push, inBody);
                    break;
                case 12:
                    body.ApplyImpulse(push, point, inBody);
                    break;
                case 13:
                    body.ApplyAngularImpulse(push, inBody);
                    break;
                case 14:
                    body.ApplyForce(10 * push, point, inBody);
                    break;
                case 15:
                    body.ApplyTorque(10 * push, inBody);
                    body.ApplyForce(10 * push, inBody);
                    break;
                case 16:
                    body.State = Crowding.Starts(13, seed, body.Plan.Asked)[random.Next(13)];
                    break;
                case 17 when random.Next(8) == 0:
                    body.Change(new BodyDescription("changed", Crowding.Masses.ElementAt(3)).With(new LinearDamping(0.1)), Keeping.Momentum);
                    break;
                case 18 when random.Next(8) == 0:
                    _ = body.Between(0.3);
                    break;
            }
        }
    }

    /// <summary>Pushes with no number above half a metre.</summary>
    private readonly struct Breaks : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += new Vector3d(body.Position.Y > 0.5 ? double.NaN : 0, 0, 0);
    }

    private static Vector3d Any(Random random) => new(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);
}
