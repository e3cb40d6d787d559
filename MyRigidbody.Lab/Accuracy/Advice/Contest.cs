using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds the cheapest of some trials by the clock, and how sure that is: those that cost nearly the same are timed for longer.</summary>
/// <remarks>
/// A round times each of them some times for a millisecond, in turns, and counts the shortest, which what else runs on the machine
/// disturbs the least. Of all rounds the lower quartile is what a step costs: no clock that slips once decides. Whoever is far dearer after
/// the first rounds is out, and whoever was dearer than the cheapest in nine of ten.
/// </remarks>
internal sealed class Contest
{
    private const int FirstRounds = 2, Rounds = 10, MostRounds = 40, TurnsPerRound = 4;
    private const double SecondsPerTurn = 0.001, WarmUp = 0.1, FarDearer = 1.5, Clear = 0.9;

    private readonly Dictionary<Trial, List<double>> _times;

    /// <summary>Takes the time of trials, of which each broke off nowhere; their <see cref="Trial.NanosecondsPerStep"/> is set.</summary>
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

        // of those that cost the same, the one that stands first
        Best = trials.First(trial => trial.Cost <= Advisor.SameCost * trials.Min(other => other.Cost));
        RunnerUp = trials.Where(trial => trial != Best).MinBy(trial => trial.Cost);
    }

    /// <summary>The cheapest.</summary>
    public Trial Best { get; }

    /// <summary>The cheapest of the others; null if there is none.</summary>
    public Trial? RunnerUp { get; }

    /// <summary>How many rounds both were in.</summary>
    public int RoundsOfBoth => RunnerUp == null ? 0 : Math.Min(_times[Best].Count, _times[RunnerUp].Count);

    /// <summary>In how many of these the best was the cheaper.</summary>
    public int RoundsWon => RunnerUp == null ? 0 : Won(Best, RunnerUp);

    /// <summary>In how many rounds of both the first was the cheaper.</summary>
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
