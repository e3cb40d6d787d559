using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics.StudentScripts.Metering;

/// <summary>
/// Counts the work of a script: the compiled script calls it in every loop, method, accessor, lambda and catch block. At the limit
/// it throws, in every later call, too, so that no catch block of the script can suppress it.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class Meter
{
    /// <summary>The limit of ticks for one message, such as Update: a right script needs a few hundred.</summary>
    internal const int PerMessage = 5_000_000;

    /// <summary>The limit of ticks for all messages of a script.</summary>
    internal const long PerScript = 200_000_000;

    // ticks between two readings of the clock
    private const int PerLook = 10_000;

    private static long _left, _leftOfMessage, _leftInAll, _ends, _endsInAll;

    /// <summary>The time limits of one message and of a whole script, ms; null where only ticks count.</summary>
    internal static (long Message, long Script)? MostTime { get; set; }

    /// <summary>The line of the last statement begun; the script sets it.</summary>
    public static int Here;

    /// <summary>Why the script was stopped; null where it was not.</summary>
    internal static Stopped? Reason { get; private set; }

    /// <summary>The line at which it was stopped; 0 where it is unknown.</summary>
    internal static int Line { get; private set; }

    /// <summary>Counts one more piece of work.</summary>
    /// <param name="line">Its line, from 1.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Tick(int line)
    {
        if (--_left < 0 || Reason != null)
            Look(line);
        if (!RuntimeHelpers.TryEnsureSufficientExecutionStack())
            Throw(Stopped.Recursion, line);
    }

    /// <summary>Begins a new script.</summary>
    internal static void Reset()
    {
        Reason = null;
        Line = Here = 0;
        _leftInAll = PerScript;
        _leftOfMessage = PerMessage;
        _left = 0;
        _endsInAll = MostTime is { } most ? Environment.TickCount64 + most.Script : long.MaxValue;
    }

    /// <summary>Begins a new message of the script.</summary>
    internal static void BeginMessage()
    {
        _leftInAll -= PerMessage - _leftOfMessage - Math.Max(_left, 0);
        _leftOfMessage = Math.Min(PerMessage, _leftInAll);
        _left = 0;
        _ends = 0;
    }

    /// <summary>Stops the script at its next tick, whatever it catches.</summary>
    internal static void Stop(Stopped reason) => Reason ??= reason;

    /// <summary>Throws if the script was stopped.</summary>
    internal static void MustNotBeStopped()
    {
        if (Reason != null)
            throw new StoppedException();
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Look(int line)
    {
        if (Reason != null || _leftOfMessage <= 0 || IsLate())
            Throw(Stopped.Endless, line);

        _left = Math.Min(PerLook, _leftOfMessage);
        _leftOfMessage -= _left--;
    }

    // a message of few ticks is not late, however slow the machine is
    private static bool IsLate()
    {
        if (MostTime is not { } most)
            return false;

        long now = Environment.TickCount64;
        if (_ends == 0)
            _ends = Math.Min(now + most.Message, Math.Max(now, _endsInAll));

        return now > _ends;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Throw(Stopped reason, int line)
    {
        Stop(reason);
        if (Line == 0)
            Line = line;

        throw new StoppedException();
    }
}

/// <summary>Why a script was stopped.</summary>
internal enum Stopped
{
    /// <summary>It works longer than a step can take.</summary>
    Endless,

    /// <summary>It calls itself without end.</summary>
    Recursion,

    /// <summary>It holds more memory than a script needs.</summary>
    Memory,
}

/// <summary>The script was stopped.</summary>
internal sealed class StoppedException : Exception;
