using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Measures the time of steps. The only clock of the library; no motion depends on it.</summary>
public static class StepClock
{
    // so many steps take long compared with reading the clock
    private const long Chunk = 2000;

    // by then a runtime has optimised code that runs often, s
    private const double WarmUp = 0.15;

    // creating a body that coasts takes longer than its steps
    private const double MostPerSecond = 5;

    // a time of so many ticks is known to some percent with any clock: those of browsers are coarse
    private const double Ticks = 40;
    private const int LeastTurns = 1, LongPiece = 1000;
    private const double LeastSeconds = 0.002, FineTick = 1e-5;

    /// <summary>Times trials alternately, so that a temporary load on the machine slows all of them.</summary>
    /// <param name="trials">The trials; their <see cref="Trial.NanosecondsPerStep"/> is set.</param>
    /// <param name="seconds">The duration of one run of each, s.</param>
    /// <param name="repeats">
    /// The largest number of rounds that count, after some that do not; the shortest time is kept, and a trial whose shortest time has come back five times is not timed again.
    /// </param>
    /// <param name="progress">Receives the finished fraction.</param>
    public static void Take(IReadOnlyList<Trial> trials, double seconds, int repeats, Action<double>? progress = null)
    {
        Guard.Positive(seconds, nameof(seconds));
        Stopwatch warm = Stopwatch.StartNew();
        TimedRun?[] runs = [.. trials.Select(trial => Guard.IsFinite(trial.Error) ? new TimedRun(trial.Scene) : null)];
        ShortestTime[] times = [.. trials.Select(_ => new ShortestTime())];
        for (int turn = 0; turn <= repeats && !times.All(time => time.IsKnown); turn += turn > 0 || warm.Elapsed.TotalSeconds > WarmUp ? 1 : 0)
        {
            for (int i = 0; i < trials.Count; i++)
            {
                if (times[i].IsKnown)
                    continue;

                double time = runs[i]?.Nanoseconds(seconds) ?? double.PositiveInfinity;
                if (turn > 0)
                    times[i].Add(time);

                progress?.Invoke((turn * trials.Count + i + 1.0) / ((repeats + 1.0) * trials.Count));
            }
        }

        // a trial may have a time from before
        for (int i = 0; i < trials.Count; i++)
            trials[i].NanosecondsPerStep = double.MinNumber(trials[i].NanosecondsPerStep, times[i].Value);
    }

    /// <summary>The time between two ticks of the clock, s: its resolution.</summary>
    internal static double Tick()
    {
        const int Looks = 10;
        long least = long.MaxValue;
        for (int i = 0; i < Looks; i++)
        {
            long now = Stopwatch.GetTimestamp(), next = now;
            while (next == now)
                next = Stopwatch.GetTimestamp();

            least = Math.Min(least, next - now);
        }

        return (double)least / Stopwatch.Frequency;
    }

    /// <summary>The least duration of a run of one trial, for a clock with that tick, s.</summary>
    internal static double SecondsAtOnce(double tick) => Math.Max(LeastSeconds, Ticks * tick);

    /// <summary>Times trials alternately until some seconds are over, with a clock that may be coarse: each run takes many ticks.</summary>
    internal static void TakeWithin(IReadOnlyList<Trial> trials, double seconds, Action<double>? progress = null)
    {
        Stopwatch all = Stopwatch.StartNew();
        double tick = Tick();
        TimedRun?[] runs = [.. trials.Select(trial => Guard.IsFinite(trial.Error) ? new TimedRun(trial.Scene, tick > FineTick ? LongPiece : TimedRun.Piece) : null)];
        double each = SecondsAtOnce(tick);
        for (int turn = 0; turn <= LeastTurns || all.Elapsed.TotalSeconds < seconds; turn++)
        {
            for (int i = 0; i < runs.Length; i++)
            {
                double time = runs[i]?.Nanoseconds(each) ?? double.PositiveInfinity;
                // in the first round the runtime still optimises
                if (turn > 0 && !(time >= trials[i].NanosecondsPerStep))
                    trials[i].NanosecondsPerStep = time;

                progress?.Invoke(Math.Min(1, all.Elapsed.TotalSeconds / seconds));
            }
        }
    }

    /// <summary>For a step of a body, ns: the scene from its start, as often as time allows. Creating the simulation is not timed.</summary>
    internal static double Nanoseconds(SceneDescription scene, Omissions mayLeaveOut, double seconds)
    {
        Simulation[] batch = new Simulation[Math.Max(1, Chunk / scene.Steps.Count)];
        Stopwatch clock = new Stopwatch();
        Stopwatch all = Stopwatch.StartNew();
        long done = 0;
        while (clock.Elapsed.TotalSeconds < seconds && (done == 0 || all.Elapsed.TotalSeconds < MostPerSecond * seconds))
        {
            for (int i = 0; i < batch.Length; i++)
                batch[i] = new Simulation(scene, mayLeaveOut);

            clock.Start();
            foreach (Simulation simulation in batch)
            {
                long left = scene.Steps.Count;
                while (left > 0 && (left <= Chunk || clock.Elapsed.TotalSeconds < seconds))
                {
                    long count = Math.Min(left, Chunk);
                    simulation.Step(count);
                    left -= count;
                    done += count;
                }
            }

            clock.Stop();
        }

        return 1e9 * clock.Elapsed.TotalSeconds / ((double)done * scene.Bodies.Count);
    }
}
