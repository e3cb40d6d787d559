using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Children;
using RigidBodyDynamics.StudentScripts.Comments;
using RigidBodyDynamics.StudentScripts.Compilation;
using RigidBodyDynamics.StudentScripts.Metering;
using RigidBodyDynamics.StudentScripts.Running;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>
/// Compiles, runs and judges scripts in this process, as <see cref="ScriptRunner"/> does in a child: for a browser, where the page
/// isolates each worker, and ends one that does not answer.
/// </summary>
internal sealed class LocalRunner
{
    // ms; a child process counts ticks instead, so that its verdict is the same on any machine
    private const long MostOfMessage = 1000, MostOfScript = 20_000;

    private readonly Coverage _coverage = new(null);
    static LocalRunner() => Meter.MostTime = (MostOfMessage, MostOfScript);

    /// <summary>Called when a script begins to run, and when it has ended.</summary>
    public required Action<bool> IsRunning { get; init; }

    /// <summary>Called after every frame of a script.</summary>
    public required Action AtWork { get; init; }

    private IReadOnlyList<ScriptFile> _files = [];
    private CheckedScript? _read;
    private CompiledScript? _compiled;
    private Finding? _noScript;

    /// <summary>What prevents running the script, with its places.</summary>
    public IReadOnlyList<Objection> Objections(IReadOnlyList<ScriptFile> files)
    {
        Read(files);
        return _read?.Objections ?? [Objection.At(Microsoft.CodeAnalysis.Location.None, _noScript!)];
    }

    /// <summary>The report on a submission that was ended from outside while it ran.</summary>
    /// <param name="files">Its source files.</param>
    /// <param name="code">The reason: endless-loop, memory, ended.</param>
    public ScriptReport Ended(IReadOnlyList<ScriptFile> files, string code) => Compile(files) is { } compiled
        ? Reports.Refused(Look.At(compiled, _coverage), files, [Words.Stopped(code, code == "ended" ? string.Empty : "Update")])
        : Reports.Refused(Look.WithoutScript(_noScript!), files, [_noScript!]);

    /// <summary>Judges one submission. Exceptions of the script are not thrown here.</summary>
    public ScriptReport Run(IReadOnlyList<ScriptFile> files)
    {
        if (Compile(files) is not { } compiled)
            return Reports.Refused(Look.WithoutScript(_noScript!), files, [_noScript!]);

        Look look = Look.At(compiled, _coverage);
        if (look.Refusals.Count > 0)
            return Reports.Refused(look, files, look.Refusals);

        // there is only one world
        Playing = null;
        IsRunning(true);
        RunOutcome outcome = Execution.Run(compiled, AtWork);
        IsRunning(false);
        return outcome.Recording is { } recording ? Reports.Judged(look, files, recording) : Reports.Refused(look, files, [outcome.Stopped!]);
    }

    /// <summary>Puts a script on an object, to be played; returns why it cannot be, or null.</summary>
    /// <param name="files">Its source files.</param>
    /// <param name="edges">The edges of the object, a box; its mesh is the unit cube's.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="delta">Length of every frame, s.</param>
    public Finding? Play(IReadOnlyList<ScriptFile> files, Vector edges, Pose pose, double delta)
    {
        Playing?.Dispose();
        Playing = null;
        if (Compile(files) is not { } compiled)
            return _noScript;
        if (compiled.Refusals.Count > 0)
            return compiled.Refusals[0];

        Playing = new LiveScript(compiled, new Setting(pose, edges, Settings.Cube.Vertices), delta);
        return Playing.Stopped;
    }

    /// <summary>The script that is played; null before one is, and after another script has been judged.</summary>
    public LiveScript? Playing { get; private set; }

    // later questions about the same text use the same compilation
    private void Read(IReadOnlyList<ScriptFile> files)
    {
        if (AreAlike(files, _files))
            return;

        _compiled = null;
        _read = ScriptCompiler.Read(files, out _noScript);
        _files = files;
    }

    private CompiledScript? Compile(IReadOnlyList<ScriptFile> files)
    {
        Read(files);
        return _compiled ??= _read == null ? null : ScriptCompiler.Compile(_read);
    }

    private static bool AreAlike(IReadOnlyList<ScriptFile> a, IReadOnlyList<ScriptFile> b) =>
        a.Count == b.Count && a.Zip(b).All(pair => pair.First.Name == pair.Second.Name && pair.First.Bytes.AsSpan().SequenceEqual(pair.Second.Bytes));
}
