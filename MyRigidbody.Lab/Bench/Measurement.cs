using System.Diagnostics;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>Something whose steps are timed: all measurements of a group alternately, so that noise affects all of them alike.</summary>
/// <param name="What">Its name in bench.csv.</param>
/// <param name="Bodies">The number of bodies that each step moves.</param>
/// <param name="Threads">The number of threads.</param>
/// <param name="Make">Creates it and returns a function that takes a number of steps.</param>
internal sealed record Measurement(string What, int Bodies, int Threads, Func<Action<long>> Make)
{
    private readonly List<double> _times = [];
    private Action<long>? _steps;
    private long _chunk = 1;

    /// <summary>Median over the repeats, ns for one body and step.</summary>
    public double Median => Quantile(0.5);

    /// <summary>Half of the repeats lie between these, ns.</summary>
    public (double Low, double High) Spread => (Quantile(0.25), Quantile(0.75));

    /// <summary>Bytes allocated by a step of all bodies, after warm-up; of all threads.</summary>
    public double BytesAllocated { get; private set; }

    /// <summary>Times a group.</summary>
    /// <param name="group">The measurements to compare.</param>
    /// <param name="repeats">The number of repeats.</param>
    /// <param name="seconds">The duration of each, s.</param>
    /// <param name="report">Receives the finished fraction.</param>
    public static void Take(IReadOnlyList<Measurement> group, int repeats, double seconds, Action<double> report)
    {
        foreach (Measurement measurement in group)
            measurement.WarmUp(seconds);

        for (int repeat = 0; repeat < repeats; repeat++)
        {
            foreach (Measurement measurement in group)
                measurement._times.Add(measurement.Run());

            report((repeat + 1.0) / repeats);
        }

        foreach (Measurement measurement in group)
            measurement.Finish();
    }

    /// <summary>
    /// The ratio to another measurement of its group: of the shortest repeats, in each of which both ran, because other programs
    /// only add time.
    /// </summary>
    public double RatioTo(Measurement other) => _times.Min() / other._times.Min();

    /// <summary>The ratio of every second repeat to the others: differs from one where the machine was busy.</summary>
    public double RatioToItself => _times.Where((_, i) => i % 2 == 1).Min() / _times.Where((_, i) => i % 2 == 0).Min();

    private void WarmUp(double seconds)
    {
        _steps = Make();
        // long enough for the runtime to optimise, whatever else the machine does, and to find how many steps
        // fill the time
        Stopwatch clock = Stopwatch.StartNew();
        TimeSpan before = Environment.CpuUsage.TotalTime;
        double last = 0;
        for (int calls = 0; (Environment.CpuUsage.TotalTime - before).TotalSeconds < Math.Max(0.3, 2 * seconds) || calls < 3; calls++)
        {
            double start = clock.Elapsed.TotalSeconds;
            _steps(_chunk);
            last = (clock.Elapsed.TotalSeconds - start) / _chunk;
            // many short calls, because a runtime counts calls before it optimises
            _chunk = last * _chunk < 1e-3 ? Math.Min(2 * _chunk, 1 << 16) : _chunk;
        }

        _chunk = Math.Max(1, (long)Math.Min(seconds / last, 1e9));
        _steps(_chunk);
    }

    private double Run()
    {
        Stopwatch clock = Stopwatch.StartNew();
        _steps!(_chunk);
        return 1e9 * clock.Elapsed.TotalSeconds / ((double)_chunk * Bodies);
    }

    private void Finish()
    {
        long before = GC.GetTotalAllocatedBytes(precise: true);
        _steps!(_chunk);
        BytesAllocated = (GC.GetTotalAllocatedBytes(precise: true) - before) / (double)_chunk;
        _steps = null;
    }

    private double Quantile(double part)
    {
        List<double> sorted = [.. _times.Order()];
        return sorted[(int)Math.Round(part * (sorted.Count - 1))];
    }
}
