namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>Checks a child regularly, and kills it when it uses too much.</summary>
internal sealed class Watch : IDisposable
{
    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(50);

    private readonly Timer _timer;
    private readonly CancellationTokenRegistration _stop;

    public Watch(Child child, double mostProcessorTime, double mostTime, long mostMemory, CancellationToken stop)
    {
        double processorTimeAtStart = child.Use.ProcessorTime;
        DateTime start = DateTime.UtcNow;
        _stop = stop.Register(child.Kill);
        _timer = new Timer(
            _ =>
            {
                (double processorTime, long memory) = child.Use;
                Why ??= memory > mostMemory ? "memory"
                    : processorTime - processorTimeAtStart > mostProcessorTime ? "endless-loop"
                    : (DateTime.UtcNow - start).TotalSeconds > mostTime ? "does-not-end" : null;
                if (Why != null)
                    child.Kill();
            },
            null,
            Every,
            Every);
    }

    /// <summary>Why it was killed; null where it was not.</summary>
    public string? Why { get; private set; }

    public void Dispose()
    {
        // waits for a check that is running
        using (ManualResetEvent done = new(false))
        {
            if (_timer.Dispose(done))
                done.WaitOne();
        }

        _stop.Dispose();
    }
}

/// <summary>The cause of a child's death.</summary>
internal static class Deaths
{
    public static string Code(string lastWords) =>
        lastWords.Contains("Stack overflow", StringComparison.Ordinal) || lastWords.Contains("InsufficientExecutionStack", StringComparison.Ordinal) ? "endless-recursion"
        : lastWords.Contains("Out of memory", StringComparison.Ordinal) || lastWords.Contains("OutOfMemory", StringComparison.Ordinal) ? "memory"
        : "ended";
}
