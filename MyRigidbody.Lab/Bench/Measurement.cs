using System.Diagnostics;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>Something whose steps are timed: all measurements of a group in turn, so that noise meets all of them alike.</summary>
/// <param name="What">What it is, as in bench.csv.</param>
/// <param name="Bodies">How many bodies each step moves.</param>
/// <param name="Threads">By how many threads.</param>
/// <param name="Make">Makes it anew and gives what takes a number of steps.</param>
internal sealed record Measurement(string What, int Bodies, int Threads, Func<Action<long>> Make)
{
    private readonly List<double> _times = [];
    private Action<long>? _steps;
    private long _chunk = 1;

    /// <summary>Median over the repeats, ns for one body and step.</summary>
    public double Median => Quantile(0.5);

    /// <summary>Half of the repeats lie between these, ns.</summary>
    public (double Low, double High) Spread => (Quantile(0.25), Quantile(0.75));

    /// <summary>Bytes allocated by a step of all bodies, once warm; of all threads.</summary>
    public double BytesAllocated { get; private set; }

    /// <summary>Takes the times of a group.</summary>
    /// <param name="group">What is compared.</param>
    /// <param name="repeats">How often each is timed.</param>
    /// <param name="seconds">For how long, each time.</param>
    /// <param name="report">Told the fraction that is done.</param>
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
    /// How many times as long as another of its group: the shortest of the repeats, in each of which both ran, since what else the
    /// machine does only ever adds.
    /// </summary>
    public double RatioTo(Measurement other) => _times.Min() / other._times.Min();

    /// <summary>How many times as long every second repeat took as the others between them; more or less than once where the machine was busy.</summary>
    public double RatioToItself => _times.Where((_, i) => i % 2 == 1).Min() / _times.Where((_, i) => i % 2 == 0).Min();

    private void WarmUp(double seconds)
    {
        _steps = Make();
        // long enough for a runtime that compiles again what runs often, whatever else the machine does, and to know how many steps
        // fill the time
        Stopwatch clock = Stopwatch.StartNew();
        TimeSpan before = Environment.CpuUsage.TotalTime;
        double last = 0;
        for (int calls = 0; (Environment.CpuUsage.TotalTime - before).TotalSeconds < Math.Max(0.3, 2 * seconds) || calls < 3; calls++)
        {
            double start = clock.Elapsed.TotalSeconds;
            _steps(_chunk);
            last = (clock.Elapsed.TotalSeconds - start) / _chunk;
            // many short calls: a runtime counts them before it compiles well
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
