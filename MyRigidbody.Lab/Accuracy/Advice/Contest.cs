using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds the cheapest of some trials by timing, and the certainty of that: trials of nearly equal cost are timed for longer.</summary>
/// <remarks>
/// A round times each trial several times for a millisecond, alternately, and takes the shortest time, which other programs on the
/// machine disturb the least. The cost of a step is the lower quartile over the rounds, so one wrong time does not decide. A trial that is
/// far more expensive after the first rounds, or more expensive than the cheapest in nine of ten rounds, is not timed further.
/// </remarks>
internal sealed class Contest
{
    private const int FirstRounds = 2, Rounds = 10, MostRounds = 40, TurnsPerRound = 4;
    private const double SecondsPerTurn = 0.001, WarmUp = 0.1, FarDearer = 1.5, Clear = 0.9;

    private readonly Dictionary<Trial, List<double>> _times;

    /// <summary>Times trials, all of which ran to their end; sets their <see cref="Trial.NanosecondsPerStep"/>.</summary>
    public Contest(IReadOnlyList<Trial> trials, Action<double>? progress = null)
    {
        _times = trials.ToDictionary(trial => trial, _ => new List<double>());
        Dictionary<Trial, TimedRun> runs = trials.ToDictionary(trial => trial, trial => new TimedRun(trial.Scene));
        Stopwatch warm = Stopwatch.StartNew();
        while (warm.Elapsed.TotalSeconds < WarmUp)
            Round(runs);

        List<Trial> left = [.. trials];
        for (int round = 1; round <= MostRounds && (round <= Rounds || left.Count > 1); round++)
        {
            foreach ((Trial trial, double time) in Round(runs))
            {
                _times[trial].Add(time);
                trial.NanosecondsPerStep = _times[trial].Order().ElementAt(_times[trial].Count / 4);
            }

            if (round >= FirstRounds)
            {
                Trial[] cheapest = [.. left.OrderBy(trial => trial.Cost).Take(2)];
                left.RemoveAll(trial => trial.Cost > FarDearer * cheapest[^1].Cost || (round >= Rounds && Won(cheapest[0], trial) >= Clear * round));
                foreach (Trial trial in runs.Keys.Except(left).ToArray())
                    runs.Remove(trial);
            }

            progress?.Invoke((double)round / Rounds);
        }

        // of equal costs, the first
        Best = trials.First(trial => trial.Cost <= Advisor.SameCost * trials.Min(other => other.Cost));
        RunnerUp = trials.Where(trial => trial != Best).MinBy(trial => trial.Cost);
    }

    /// <summary>The cheapest.</summary>
    public Trial Best { get; }

    /// <summary>The cheapest of the others; null if there is none.</summary>
    public Trial? RunnerUp { get; }

    /// <summary>The number of rounds in which both were timed.</summary>
    public int RoundsOfBoth => RunnerUp == null ? 0 : Math.Min(_times[Best].Count, _times[RunnerUp].Count);

    /// <summary>The number of these rounds in which the best was the cheaper.</summary>
    public int RoundsWon => RunnerUp == null ? 0 : Won(Best, RunnerUp);

    /// <summary>The number of rounds of both in which the first was the cheaper.</summary>
    private int Won(Trial a, Trial b) => _times[a].Zip(_times[b], (one, other) => one / a.Step < other / b.Step).Count(isCheaper => isCheaper);

    private static IEnumerable<(Trial Trial, double Time)> Round(Dictionary<Trial, TimedRun> runs)
    {
        Dictionary<Trial, double> least = [];
        for (int turn = 0; turn < TurnsPerRound; turn++)
        {
            foreach ((Trial trial, TimedRun run) in runs)
                least[trial] = Math.Min(least.GetValueOrDefault(trial, double.PositiveInfinity), run.Nanoseconds(SecondsPerTurn));
        }

        return [.. least.Select(pair => (pair.Key, pair.Value))];
    }
}
