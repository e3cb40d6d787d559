using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Children;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>
/// Compiles and runs scripts of students in a child process, which may die, and judges its recording here. For one thread at a time;
/// create one for each core. A script cannot affect another one through its child: a damaged child is replaced.
/// </summary>
public sealed class ScriptRunner : IDisposable
{
    // the meter stops any script long before; this is for what the meter cannot see
    private const double MostProcessorTime = 10, MostTime = 120;

    private const long MostMemory = 1_200_000_000;

    private const int ScriptsPerChild = 200;

    private readonly string _starter;
    private Child? _child;
    private int _served;

    /// <summary>The starter for counting comments where none is given.</summary>
    public static string SheetStarter => Comments.Coverage.Sheets();

    /// <param name="starter">The text of the starter, for the count of comments; null for the sheet's.</param>
    public ScriptRunner(string? starter = null) => _starter = starter ?? string.Empty;

    /// <summary>Where a single-file program was started as its own child: serves until its parent goes away.</summary>
    /// <param name="arguments">The program's arguments.</param>
    /// <param name="exitCode">The child's exit code.</param>
    /// <returns>True if it was a child.</returns>
    public static bool WasChild(string[] arguments, out int exitCode)
    {
        bool isChild = arguments is [Server.Command] && Child.IsThisProgram && Console.IsInputRedirected;
        exitCode = isChild ? Server.Run() : 0;
        return isChild;
    }

    /// <summary>Starts the child before it is needed.</summary>
    public void WarmUp() => _child ??= Child.Start(_starter);

    /// <summary>Judges one submission. Exceptions of the script are not thrown here.</summary>
    /// <param name="files">Its source files.</param>
    /// <param name="stop">Ends the child and throws.</param>
    public ScriptReport Run(IReadOnlyList<ScriptFile> files, CancellationToken stop = default)
    {
        if (_served >= ScriptsPerChild || _child?.HasExited == true)
            Replace();

        bool isFresh = _child == null;
        Attempt first = Try(files, stop);
        // an earlier script may be the cause: the child's death counts only if a new child dies, too
        return first.Died && !isFresh ? Try(files, stop).Report : first.Report;
    }

    public void Dispose() => Replace();

    private Attempt Try(IReadOnlyList<ScriptFile> files, CancellationToken stop)
    {
        WarmUp();
        _served++;
        using Watch watch = new(_child!, MostProcessorTime, MostTime, MostMemory, stop);
        Look? look = null;
        try
        {
            Pipe.Write(_child!.Input, files);
            look = Look.Read(_child.Output);
            if (look.Refusals.Count > 0)
                return new Attempt(Reports.Refused(look, files, look.Refusals), false);

            if (_child.Output.ReadBoolean())
                return new Attempt(Reports.Judged(look, files, Recording.ReadFrom(new MemoryStream(Pipe.ReadBytes(_child.Output)))), false);

            Finding stopped = Pipe.ReadFinding(_child.Output);
            if (stopped.Code == "memory")
                Replace();

            return new Attempt(Reports.Refused(look, files, [stopped]), false);
        }
        catch (Exception broken) when (broken is IOException or InvalidDataException or FormatException or ArgumentException or NotSupportedException)
        {
            stop.ThrowIfCancellationRequested();
            // its last output may arrive after its end
            Child dead = _child!;
            _child = null;
            dead.Dispose();
            string code = look == null ? "too-complex" : watch.Why ?? Deaths.Code(dead.LastWords);
            Finding died = Words.Stopped(code, code is "ended" or "too-complex" ? dead.LastWords.Split('\n')[0].Trim() : "Update");
            return new Attempt(Reports.Refused(look, files, [died]), watch.Why == null);
        }
    }

    private void Replace()
    {
        _child?.Dispose();
        _child = null;
        _served = 0;
    }

    private sealed record Attempt(ScriptReport Report, bool Died);
}
