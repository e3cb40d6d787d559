using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds the cheapest of some trials by the clock, and how sure that is: those that cost nearly the same are timed for longer.</summary>
/// <remarks>
/// A round times each of them some times for a millisecond, in turns, and counts the shortest, which what else runs on the machine
/// disturbs the least. Of all rounds the lower quartile is what a step costs: no clock that slips once decides. Whoever is far dearer after
/// the first rounds is out.
/// </remarks>
internal sealed class Contest
{
    private const int FirstRounds = 4, Rounds = 10, MostRounds = 40, TurnsPerRound = 4;
    private const double SecondsPerTurn = 0.001, WarmUp = 0.1, FarDearer = 1.5, Near = 1.15;

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
        for (int round = 1; round <= MostRounds && (round <= Rounds || IsNear(left)); round++)
        {
            foreach ((Trial trial, double time) in Round(runs))
            {
                _times[trial].Add(time);
                trial.NanosecondsPerStep = _times[trial].Order().ElementAt(_times[trial].Count / 4);
            }

            if (round >= FirstRounds && round % FirstRounds == 0)
            {
                double dearest = FarDearer * left.OrderBy(trial => trial.Cost).ElementAt(Math.Min(1, left.Count - 1)).Cost;
                foreach (Trial trial in left.Where(trial => trial.Cost > dearest))
                    runs.Remove(trial);

                left.RemoveAll(trial => trial.Cost > dearest);
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
    public int RoundsWon => RunnerUp == null ? 0 : _times[Best].Zip(_times[RunnerUp], (best, other) => best / Best.Step < other / RunnerUp.Step).Count(isCheaper => isCheaper);

    private static bool IsNear(List<Trial> left) =>
        left.Count > 1 && left.Order(Comparer<Trial>.Create((a, b) => a.Cost.CompareTo(b.Cost))).ElementAt(1).Cost < Near * left.Min(trial => trial.Cost);

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
