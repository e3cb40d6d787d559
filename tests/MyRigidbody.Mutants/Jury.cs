using System.Diagnostics;

namespace RigidBodyDynamics.Mutants;

/// <summary>Judges mutants, two at a time.</summary>
internal sealed class Jury(CoreCompilation core, Plan plan, string scratch, string testFolder, bool withoutGolden, Action<IEnumerable<Outcome>> save)
{
    private const int Workers = 2;
    private const int SecondsBetweenLines = 15;

    /// <summary>What became of each, in their order.</summary>
    public Outcome[] Of(IReadOnlyList<Mutant> mutants)
    {
        Outcome[] outcomes = new Outcome[mutants.Count];
        // shuffled, so that what is known on the way is what can be expected of all
        int[] order = [.. Enumerable.Range(0, mutants.Count)];
        new Random(1).Shuffle(order);
        int next = -1;
        Stopwatch watch = Stopwatch.StartNew();
        void Tell()
        {
            Outcome[] known = [.. outcomes.Where(found => found != null)];
            save(known);
            int survive = known.Count(found => found.Fate is Fate.Survived or Fate.KilledByGolden);
            Console.WriteLine($"{known.Length} of {mutants.Count} mutants, {survive} survive, {watch.Elapsed.TotalMinutes:F1} min");
        }

        using Timer progress = new(_ => Tell(), null, SecondsBetweenLines * 1000, SecondsBetweenLines * 1000);
        void Work()
        {
            using WorkerProcess worker = new(scratch, testFolder);
            for (int n = Interlocked.Increment(ref next); n < mutants.Count; n = Interlocked.Increment(ref next))
            {
                int i = order[n];
                outcomes[i] = Of(mutants[i], worker);
                if (outcomes[i].Fate is Fate.Survived or Fate.KilledByGolden)
                    Console.WriteLine($"  {mutants[i].File}: {mutants[i].Line}: {mutants[i].Change}{(outcomes[i].Fate == Fate.Survived ? "" : " (golden)")}");
            }
        }

        Thread[] threads = [.. Enumerable.Range(0, Workers).Select(_ => new Thread(Work))];
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();
        return outcomes;
    }

    private Outcome Of(Mutant mutant, WorkerProcess worker)
    {
        byte[]? image = core.With(mutant);
        if (image == null)
            return new Outcome(mutant, Fate.NotOne, "");

        Verdict verdict = Judge(worker, image, plan.For(mutant, golden: false));
        if (verdict.Failed != null)
        {
            plan.Noticed(mutant, verdict.Failed);
            return new Outcome(mutant, verdict.TimedOut ? Fate.TimedOut : Fate.Killed, verdict.Failed);
        }

        verdict = withoutGolden ? verdict : Judge(worker, image, plan.For(mutant, golden: true));
        return new Outcome(mutant, verdict.Failed != null ? Fate.KilledByGolden : Fate.Survived, verdict.Failed ?? "");
    }

    private static Verdict Judge(WorkerProcess worker, byte[] image, Batch[] batches) =>
        batches.Length == 0 ? new Verdict(null, false, 0) : worker.Judge(image, batches);
}
