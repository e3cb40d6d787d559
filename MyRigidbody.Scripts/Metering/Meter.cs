using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics.StudentScripts.Metering;

/// <summary>
/// Counts what a script does: the compiled script calls it in every loop, method, accessor, lambda and catch block. When there is
/// too much it throws, and since it goes on throwing, no catch block of the script can swallow it.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class Meter
{
    /// <summary>Ticks for one message, such as Update: a right script takes a few hundred.</summary>
    internal const int PerMessage = 5_000_000;

    /// <summary>Ticks for all messages of a script.</summary>
    internal const long PerScript = 200_000_000;

    private static long _left, _leftInAll;

    /// <summary>Why the script was stopped; null while it was not.</summary>
    internal static Stopped? Reason { get; private set; }

    /// <summary>The line at which it was stopped; 0 where none is known.</summary>
    internal static int Line { get; private set; }

    /// <summary>One more piece of work.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Tick()
    {
        if (--_left < 0 || Reason != null)
            Throw(Stopped.Endless);
        if (!RuntimeHelpers.TryEnsureSufficientExecutionStack())
            Throw(Stopped.Recursion);
    }

    /// <summary>A new script.</summary>
    internal static void Reset()
    {
        Reason = null;
        Line = 0;
        _leftInAll = PerScript;
        _left = PerMessage;
    }

    /// <summary>A new message of the script.</summary>
    internal static void BeginMessage()
    {
        _leftInAll -= PerMessage - Math.Max(_left, 0);
        _left = Math.Min(PerMessage, _leftInAll);
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
    private static void Throw(Stopped reason)
    {
        Stop(reason);
        // this method, Tick, the script: a stack that is full takes long to be read whole
        if (Line == 0)
            Line = new StackFrame(2, needFileInfo: true).GetFileLineNumber();

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

    /// <summary>It keeps more memory than a script needs.</summary>
    Memory,
}

/// <summary>The script was stopped.</summary>
internal sealed class StoppedException : Exception;
