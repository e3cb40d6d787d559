using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Takes the time that steps need. The one clock of the library, and no motion depends on it.</summary>
public static class StepClock
{
    // so many steps take long beside a look at the clock
    private const long Chunk = 2000;

    // a runtime that compiles again what runs often has done so by then, s
    private const double WarmUp = 0.15;

    // a body that coasts takes its steps in less time than it takes to make it
    private const double MostPerSecond = 5;

    // a time of so many ticks is known to some percent, whatever the clock: browsers make theirs coarse
    private const double Ticks = 40;
    private const int LeastTurns = 1, LongPiece = 1000;
    private const double LeastSeconds = 0.002, FineTick = 1e-5;

    /// <summary>Takes the time of trials in turns, so that what slows the machine for a while slows all of them.</summary>
    /// <param name="trials">The trials; their <see cref="Trial.NanosecondsPerStep"/> is set.</param>
    /// <param name="seconds">How long each of them runs in a turn.</param>
    /// <param name="repeats">
    /// How many turns count at most, after some that do not; the shortest time is kept, and one that has come back five times is not taken again.
    /// </param>
    /// <param name="progress">Told the fraction that is done.</param>
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

    /// <summary>The time between two ticks of the clock, s: what it cannot tell apart.</summary>
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

    /// <summary>How long a trial runs at least before the next has its turn, by a clock with that tick, s.</summary>
    internal static double SecondsAtOnce(double tick) => Math.Max(LeastSeconds, Ticks * tick);

    /// <summary>Takes the time of trials in turns until some seconds are over, by a clock that may be coarse: as many steps at once as take many of its ticks.</summary>
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
                // the first turn is for a runtime that compiles what runs often
                if (turn > 0 && !(time >= trials[i].NanosecondsPerStep))
                    trials[i].NanosecondsPerStep = time;

                progress?.Invoke(Math.Min(1, all.Elapsed.TotalSeconds / seconds));
            }
        }
    }

    /// <summary>For a step of a body, ns: the scene from its start on, as often as fits. To make it takes no time of the clock.</summary>
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
