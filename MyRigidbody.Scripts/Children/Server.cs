using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Comments;
using RigidBodyDynamics.StudentScripts.Compilation;
using RigidBodyDynamics.StudentScripts.Running;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>The child's side: submissions come by standard input, and recordings go out by standard output.</summary>
internal static class Server
{
    /// <summary>The argument with which a process becomes a child.</summary>
    public const string Command = "serve";

    // more than any script of the lab needs, and little enough that the compiler soon gives up on endless nesting
    private const int StackBytes = 8 << 20;

    /// <summary>Serves until standard input ends; then exits at once, whatever a script is doing.</summary>
    public static int Run()
    {
        using BinaryReader input = new(Console.OpenStandardInput());
        using Stream output = Console.OpenStandardOutput();
        // output of scripts is discarded
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
                // the parent waits for each answer; if it goes away meanwhile, the read ends, and this process with it
                // each answer has a buffer of its own, because the next question may come before this thread has released its buffer
                new Thread(() => Serve(files, coverage, new BinaryWriter(new BufferedStream(output, 1 << 16))), StackBytes) { IsBackground = true }.Start();
            }
        }
        catch (EndOfStreamException)
        {
            TakeAwayFolder();
            return 0;
        }
    }

    // the parent deletes the folder, unless it was killed
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
            // it is already deleted
        }
    }

    private static void Serve(IReadOnlyList<ScriptFile> files, Coverage coverage, BinaryWriter output)
    {
        CheckedScript? read = ScriptCompiler.Read(files, out Finding? noScript);
        CompiledScript? compiled = read == null ? null : ScriptCompiler.Compile(read);
        (compiled == null ? Look.WithoutScript(noScript!) : Look.At(compiled, coverage)).Write(output);
        // it may be this process's last output
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
