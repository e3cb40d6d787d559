using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Threads come late, are dismissed before they came, and are called anew: each body is stepped once a step, by one.</summary>
[NonParallelizable]
public sealed class BatchThreadsTests
{
    private const int Bodies = 24 * 1024, Steps = 10, PoolThreads = 24;
    private static int _workers, _ports;

    [OneTimeSetUp]
    public static void Widen_the_pool()
    {
        ThreadPool.GetMinThreads(out _workers, out _ports);
        ThreadPool.SetMinThreads(PoolThreads, _ports);
    }

    [OneTimeTearDown]
    public static void Narrow_it_again() => ThreadPool.SetMinThreads(_workers, _ports);

    // in lanes an effect that reads no state is evaluated once a step for all bodies of a part, by other integrators for each body
    [TestCase("LabEuler", 5)]
    [TestCase("Exact", 5)]
    [TestCase("RungeKutta4", 1000)]
    public void Number_of_threads_may_change_while_helpers_are_in_the_queue(string rule, int callsBetweenSleeps)
    {
        BodyState[] starts = Crowding.Starts(Bodies, 3, Body(null)), expected = new BodyState[Bodies], found = new BodyState[Bodies];
        Together one = Filled(1, null);
        one.Step(1 + Steps + 3);
        one.Read(expected);
        for (int round = 0; round < 4; round++)
        {
            using ManualResetEventSlim go = new();
            using CountdownEvent waiting = new(PoolThreads);
            Together many = Filled(8, go);
            Task[] busy = [.. Enumerable.Range(0, PoolThreads).Select(_ => Task.Run(() =>
            {
                waiting.Signal();
                go.Wait();
            }))];
            waiting.Wait();
            // the helpers that are called here find no thread before those of the next call are in the queue as well, and work is there
            many.Step();
            many.Threads = 1;
            many.Threads = 8;
            many.Step(Steps);
            many.Threads = 2;
            many.Step(3);
            Task.WaitAll(busy);
            many.Read(found);
            for (int i = 0; i < found.Length; i++)
                Crowding.Same(found[i], expected[i], $"round {round}, body {i}");
        }

        BodyDescription Body(ManualResetEventSlim? go) =>
            new BodyDescription("body", Crowding.Masses.First()) { Rule = Rules.Named(rule) }.With(new Starter(go, callsBetweenSleeps));

        Together Filled(int threads, ManualResetEventSlim? go)
        {
            Together batch = new(Body(go), TimeSteps.Every(0.02), Omissions.None) { Threads = threads };
            foreach (BodyState start in starts)
                batch.Add(start);

            return batch;
        }
    }

    /// <summary>
    /// Pushes with nothing, and lets the pool go when its second step is asked for. From then on it sleeps now and then, so that another
    /// thread comes while a part is half done.
    /// </summary>
    private readonly struct Starter(ManualResetEventSlim? go, int callsBetweenSleeps) : IPush
    {
        [ThreadStatic]
        private static int _calls;

        public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.Step < 1 || go is null)
                return;

            if (!go.IsSet)
                go.Set();

            if (++_calls % callsBetweenSleeps == 0)
                Thread.Sleep(1);
        }
    }
}
