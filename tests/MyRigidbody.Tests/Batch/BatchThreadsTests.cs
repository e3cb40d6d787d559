using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Threads come late, are dismissed before they came, and are called anew: each body is stepped once a step, by one.</summary>
[NonParallelizable]
public sealed class BatchThreadsTests
{
    private const int Bodies = 8 * 1024;

    [TestCase("LabEuler", "nothing")]
    [TestCase("Exact", "torque")]
    [TestCase("Exact4", "spring")]
    public void Number_of_threads_may_change_while_the_pool_is_busy(string rule, string act)
    {
        BodyDescription body = new("body", Crowding.Masses.First()) { Integrator = rule };
        if (act == "torque")
            body.With(Torque.Constant(new Vector3d(0.1, 0.2, -0.1)), 0.5);
        else if (act == "spring")
            body.With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4), 0.1, 0.6);

        BodyState[] starts = Crowding.Starts(Bodies, 3, body), expected = new BodyState[Bodies], found = new BodyState[Bodies];
        Batch one = Filled(1);
        one.Step(1 + 1 + 40 + 3);
        one.Read(expected);
        for (int round = 0; round < 30; round++)
        {
            Batch many = Filled(8);
            using ManualResetEventSlim go = new();
            int threads = ThreadPool.ThreadCount + Environment.ProcessorCount;
            Task[] busy = [.. Enumerable.Range(0, threads).Select(_ => Task.Run(() => go.Wait()))];
            // the helpers that are called now find no thread before those of the next call are there as well
            many.Step();
            many.Threads = 1;
            many.Threads = 8;
            many.Step();
            many.Threads = 3;
            many.Threads = 8;
            go.Set();
            many.Step(40);
            many.Threads = 2;
            many.Step(3);
            Task.WaitAll(busy);
            many.Read(found);
            for (int i = 0; i < found.Length; i++)
                Crowding.Same(found[i], expected[i], $"round {round}, body {i}");
        }

        Batch Filled(int threads)
        {
            Batch batch = new(body, TimeSteps.Every(0.02), Omissions.None) { Threads = threads };
            foreach (BodyState start in starts)
                batch.Add(start);

            return batch;
        }
    }
}
