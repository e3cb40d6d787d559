using System.Diagnostics;

namespace RigidBodyDynamics.Fuzz;

/// <summary>Ends the program when an input takes too long, and names it.</summary>
internal sealed class Watchdog : IDisposable
{
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly TimeSpan _longest;
    private readonly Action _bark;
    private readonly Timer _timer;

    /// <summary>Checks from time to time.</summary>
    /// <param name="longest">How long an input may take.</param>
    /// <param name="bark">What to do if one takes longer.</param>
    public Watchdog(TimeSpan longest, Action bark)
    {
        _longest = longest;
        _bark = bark;
        _timer = new Timer(_ => Look(), null, longest / 10, longest / 10);
    }

    /// <summary>How long the current input has taken.</summary>
    public TimeSpan Elapsed => _clock.Elapsed;

    /// <summary>The next input begins.</summary>
    public void Next() => _clock.Restart();

    /// <inheritdoc/>
    public void Dispose() => _timer.Dispose();

    private void Look()
    {
        if (_clock.Elapsed > _longest)
            _bark();
    }
}
