using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies are added, removed and read in any order, without effect on the others.</summary>
public sealed class BatchLifeTests
{
    // sums of this length are exact, so that time may begin anywhere
    private static readonly TimeSteps Steps = TimeSteps.Every(1 / 64.0);

    private static readonly Dictionary<string, Func<BodyDescription, BodyDescription>> Acting = new()
    {
        ["Exact, nothing"] = body => body,
        ["Exact, gravity and damping"] = body => body.With(new Gravity(new Vector3d(0.1, -9.81, 0))).With(new LinearDamping(0.3)).With(new AngularDamping(0.02)),
        ["Exact, torque"] = body => body.With(Torque.Constant(new Vector3d(0.1, 0.2, -0.1))),
        ["Exact4, spring"] = body => body.With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4)),
        ["LabEuler, factors per step"] = body => body.With(new DecayPerStep(0.98, 0.98)),
    };

    [Test]
    public void Bodies_come_and_go_and_each_moves_as_if_it_were_alone(
        [Values("Exact, nothing", "Exact, gravity and damping", "Exact, torque", "Exact4, spring", "LabEuler, factors per step")] string act,
        [Values(1, 5, 6)] int mass)
    {
        Random random = new(mass);
        int longest = act == "Exact, nothing" || act == "Exact, gravity and damping" ? 300 : 9;
        BodyDescription body = Acting[act](new BodyDescription("body", Crowding.Masses.ElementAt(mass)) { Rule = Rules.Named(act.Split(',')[0]) });
        BodyState[] starts = Crowding.Starts(200, 2, body);
        Together batch = new(body, Steps);
        Dictionary<int, (long Since, Simulation Alone)> alone = [];
        for (int i = 0; i < 300; i++)
        {
            int[] ids = [.. alone.Keys];
            switch (ids.Length == 0 ? 0 : random.Next(8))
            {
                case 0 or 1 when alone.Count < 40:
                    BodyDescription one = body.Copy("alone", body.Mass);
                    one.Start = starts[i % starts.Length];
                    alone.Add(batch.Add(one.Start), (batch.StepsDone, new Simulation(new SceneDescription("alone", "", Steps, [one]), Omissions.Coasting)));
                    break;
                case 2:
                    int leaving = ids[random.Next(ids.Length)];
                    batch.Remove(leaving);
                    alone.Remove(leaving);
                    break;
                case 3 or 4:
                    batch.Step(random.Next(1, random.Next(2, longest)));
                    break;
                case 5:
                    BodyState[] all = new BodyState[batch.EndOfIds];
                    batch.Read(all);
                    foreach (int id in ids)
                        Check(id, all[id]);
                    break;
                default:
                    int some = ids[random.Next(ids.Length)];
                    Check(some, batch[some]);
                    break;
            }

            Assert.That(batch.Count, Is.EqualTo(alone.Count));
        }

        void Check(int id, BodyState found)
        {
            (long since, Simulation simulation) = alone[id];
            simulation.Step(batch.StepsDone - since - simulation.StepsDone);
            Crowding.Same(found, simulation.Bodies[0].State, $"body {id}, {act}, {since} to {batch.StepsDone}");
        }
    }

    [Test]
    public void Bits_do_not_depend_on_when_states_are_read()
    {
        // two stretches in which the bodies coast, one in which they are pushed between them
        BodyDescription body = new BodyDescription("body", Crowding.Masses.ElementAt(1))
            .With(new Gravity(new Vector3d(0, -9.81, 0)), 2).With(Torque.Constant(new Vector3d(0, 0.1, 0)), 3, 4);
        BodyState[] starts = Crowding.Starts(21, 3, body);
        Together often = new(body, Steps), once = new(body, Steps);
        foreach (BodyState start in starts)
        {
            often.Add(start);
            once.Add(start);
        }

        for (int i = 0; i < 600; i++)
        {
            often.Step();
            _ = often[i % 5 * 4];
        }

        once.Step(600);
        for (int i = 0; i < starts.Length; i++)
            Crowding.Same(often[i], once[i], "body " + i);
    }

    [Test]
    public void Bodies_that_may_not_wait_are_stepped()
    {
        BodyDescription body = new("body", Crowding.Masses.First());
        Together waits = new(body, Steps), stepped = new(body, Steps, Omissions.None);
        BodyState start = new(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(1, 2, 3));
        waits.Add(start);
        stepped.Add(start);
        waits.Step(1000);
        stepped.Step(1000);
        Simulation alone = new(new SceneDescription("alone", "", Steps, [Alone(body, start)]), Omissions.None);
        alone.Step(1000);
        Crowding.Same(stepped[0], alone.Bodies[0].State, "stepped");
        Assert.That(waits[0], Is.Not.EqualTo(stepped[0]));
        Assert.That(Conserved.AngleBetween(waits[0].Orientation, stepped[0].Orientation), Is.LessThan(1e-12)); // measured 9e-15
    }

    [TestCase("Exact, nothing", 1)]
    [TestCase("Exact, torque", 1)]
    [TestCase("Exact4, spring", 1)]
    [TestCase("LabEuler, factors per step", 2)]
    public void Stepping_reading_adding_and_removing_allocate_nothing(string act, int threads)
    {
        BodyDescription body = Acting[act](new BodyDescription("body", Crowding.Masses.First()) { Rule = Rules.Named(act.Split(',')[0]) });
        BodyState[] starts = Crowding.Starts(1200, 1, body), states = new BodyState[1200];
        Together batch = new(body, Steps) { Threads = threads };
        foreach (BodyState start in starts)
            batch.Add(start);
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
            batch.Step(3);
            batch.Remove(77);
            batch.Remove(1077);
            batch.Step();
            batch.Read(states);
            batch.Return(77, batch[5]);
            batch.Return(1077, states[78]);
            batch.Step(act == "Exact, nothing" ? 130 : 2);
            _ = batch[12];
        }
    }

    private static BodyDescription Alone(BodyDescription body, BodyState start)
    {
        BodyDescription alone = body.Copy("alone", body.Mass);
        alone.Start = start;
        return alone;
    }
}
