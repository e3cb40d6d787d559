using System.Diagnostics;
using System.Text.Json;

namespace RigidBodyDynamics.Mutants;

/// <summary>A worker seen from outside. It is started when there is work and again when it has ended or grown too large.</summary>
internal sealed class WorkerProcess(string scratch, string testFolder) : IDisposable
{
    private const long LargestMemory = 1L << 30;
    private readonly string _core = Path.Combine(scratch, Guid.NewGuid().ToString("N") + ".dll");
    private Process? _process;

    /// <summary>What all tests reach in a marked Core.</summary>
    public Coverage Cover(byte[] core) =>
        JsonSerializer.Deserialize<Coverage>(Ask(core, []) ?? throw new InvalidOperationException("the tests do not run"))!;

    /// <summary>Puts a Core to the tests. A process that ends without an answer is a failure too.</summary>
    public Verdict Judge(byte[] core, Batch[] batches)
    {
        string? answer = Ask(core, batches);
        Verdict verdict = answer == null ? new Verdict("the process ended", true, 0) : JsonSerializer.Deserialize<Verdict>(answer)!;
        if (verdict.TimedOut || verdict.Memory > LargestMemory)
            Stop();
        return verdict;
    }

    public void Dispose()
    {
        Stop();
        File.Delete(_core);
    }

    private string? Ask(byte[] core, Batch[] batches)
    {
        File.WriteAllBytes(_core, core);
        _process ??= Start();
        try
        {
            _process.StandardInput.WriteLine(JsonSerializer.Serialize(new Errand(_core, testFolder, batches)));
            return _process.StandardOutput.ReadLine();
        }
        catch (IOException)
        {
            return null;
        }
    }

    private static Process Start()
    {
        ProcessStartInfo start = new(Environment.ProcessPath!)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        if (Path.GetFileNameWithoutExtension(Environment.ProcessPath) == "dotnet")
            start.ArgumentList.Add(typeof(WorkerProcess).Assembly.Location);
        start.ArgumentList.Add("worker");
        // samples are the same in every run, and of one thread
        start.Environment["CsCheck_Seed"] = "0N0XIzNsQ0O2";
        start.Environment["CsCheck_Threads"] = "1";
        Process process = Process.Start(start)!;
        // a mutant without an end to its recursion leaves thousands of lines
        process.BeginErrorReadLine();
        return process;
    }

    private void Stop()
    {
        if (_process == null)
            return;

        _process.Kill();
        _process.WaitForExit();
        _process.Dispose();
        _process = null;
    }
}
