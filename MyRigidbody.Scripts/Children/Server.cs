using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Comments;
using RigidBodyDynamics.StudentScripts.Compilation;
using RigidBodyDynamics.StudentScripts.Running;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>The child's side: submissions come in by standard input, and what was seen goes out by standard output.</summary>
internal static class Server
{
    /// <summary>The word with which a process becomes a child.</summary>
    public const string Command = "serve";

    // more than any script of the lab needs, and little enough that the compiler soon gives up on one that nests without end
    private const int StackBytes = 8 << 20;

    /// <summary>Serves until standard input ends; then it ends at once, whatever a script is doing.</summary>
    public static int Run()
    {
        using BinaryReader input = new(Console.OpenStandardInput());
        using Stream output = Console.OpenStandardOutput();
        // what scripts write goes nowhere
        Console.SetOut(TextWriter.Null);
        Console.SetIn(TextReader.Null);
        Rights.GiveUp();
        try
        {
            new BinaryWriter(output).Write(Pipe.Ready);
            Coverage coverage = new(input.ReadString() is { Length: > 0 } starter ? starter : null);
            while (true)
            {
                IReadOnlyList<ScriptFile> files = Pipe.ReadFiles(input);
                // whoever sends waits for the answer before the next; if it goes away meanwhile, the read ends, and so does all this
                // each answer has a buffer of its own: the next question may be here before this thread has put its buffer away
                new Thread(() => Serve(files, coverage, new BinaryWriter(new BufferedStream(output, 1 << 16))), StackBytes) { IsBackground = true }.Start();
            }
        }
        catch (EndOfStreamException)
        {
            TakeAwayFolder();
            return 0;
        }
    }

    // who started this process takes the folder away, unless it was killed
    private static void TakeAwayFolder()
    {
        string folder = Directory.GetCurrentDirectory();
        try
        {
            if (Path.GetFileName(folder).StartsWith(Child.FolderPrefix, StringComparison.Ordinal))
                Directory.Delete(folder);
        }
        catch (IOException)
        {
            // it is gone already
        }
    }

    private static void Serve(IReadOnlyList<ScriptFile> files, Coverage coverage, BinaryWriter output)
    {
        CheckedScript? read = ScriptCompiler.Read(files, out Finding? noScript);
        CompiledScript? compiled = read == null ? null : ScriptCompiler.Compile(read);
        (compiled == null ? Look.WithoutScript(noScript!) : Look.At(compiled, coverage)).Write(output);
        // it may be the last that is heard of this process
        output.Flush();
        if (compiled is not { Refusals.Count: 0 })
            return;

        RunOutcome outcome = Execution.RunOnThread(compiled);
        output.Write(outcome.Recording != null);
        if (outcome.Recording == null)
        {
            Pipe.Write(output, outcome.Stopped!);
        }
        else
        {
            using MemoryStream recording = new();
            outcome.Recording.WriteTo(recording);
            Pipe.Write(output, recording.ToArray());
        }

        output.Flush();
    }
}
