using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>The parent's side of a child process: it is watched while it works, and killed when it uses too much.</summary>
internal sealed class Child : IDisposable
{
    /// <summary>The prefix of the name of a child's empty folder.</summary>
    public const string FolderPrefix = "script-";

    private const int MostErrorText = 4000;

    // the limit of a child's own heap; its other memory is measured from outside
    private const string HeapBytes = "0x18000000";

    private static readonly PosixSignal[] EndingSignals = [PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP];

    private readonly PosixSignalRegistration[] _signals;
    private readonly Process _process;
    private readonly DirectoryInfo _folder;
    private readonly StringBuilder _error = new();

    private Child(Process process, DirectoryInfo folder)
    {
        _process = process;
        _folder = folder;
        _process.ErrorDataReceived += (_, line) => Note(line.Data);
        _process.BeginErrorReadLine();
        AppDomain.CurrentDomain.ProcessExit += End;
        // a signal ends this process immediately; the child, which would delete its folder, may have got it, too
        _signals = [.. EndingSignals.Select(signal => PosixSignalRegistration.Create(signal, _ => End()))];
        Input = new BinaryWriter(_process.StandardInput.BaseStream);
        Output = new BinaryReader(new BufferedStream(_process.StandardOutput.BaseStream, 1 << 16));
    }

    /// <summary>True if the child is this program once more: a single file, without an assembly for the child beside it.</summary>
    public static bool IsThisProgram => !File.Exists(Assembly);

    public BinaryWriter Input { get; }

    public BinaryReader Output { get; }

    /// <summary>Processor time used, s, and memory held, bytes; zero after its end.</summary>
    public (double ProcessorTime, long Memory) Use
    {
        get
        {
            try
            {
                _process.Refresh();
                return (_process.TotalProcessorTime.TotalSeconds, _process.WorkingSet64);
            }
            catch (Exception ended) when (ended is InvalidOperationException or System.ComponentModel.Win32Exception)
            {
                return (0, 0);
            }
        }
    }

    /// <summary>Its last output before its death.</summary>
    public string LastWords
    {
        get
        {
            lock (_error)
                return _error.ToString();
        }
    }

    public bool HasExited => _process.HasExited;

    /// <summary>Starts a child and waits until it is ready.</summary>
    /// <exception cref="InvalidOperationException">It does not start.</exception>
    public static Child Start(string starter)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory(FolderPrefix);
        (string program, string[] arguments) = Program();
        ProcessStartInfo start = new(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            CreateNoWindow = true,
            WorkingDirectory = folder.FullName,
        };
        // no rights through the environment, and no files of the runtime in the folder for temporary files
        Dictionary<string, string?> kept = new[] { "SystemRoot", "LD_LIBRARY_PATH", "LANG" }.ToDictionary(name => name, Environment.GetEnvironmentVariable);
        start.Environment.Clear();
        foreach ((string name, string? value) in kept)
        {
            if (value != null)
                start.Environment[name] = value;
        }

        foreach (string name in new[] { "TMPDIR", "TEMP", "TMP", "HOME", "USERPROFILE" })
            start.Environment[name] = folder.FullName;

        start.Environment["DOTNET_GCHeapHardLimit"] = HeapBytes;
        start.Environment["DOTNET_EnableDiagnostics"] = "0";
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        start.Environment["DOTNET_DbgEnableMiniDump"] = "0";
        start.Environment["DOTNET_TieredPGO"] = "0";
        start.Environment["DOTNET_gcConcurrent"] = "0";
        Child child = new(Process.Start(start)!, folder);
        try
        {
            child.Input.Write(starter);
            child.Input.Flush();
            if (child.Output.ReadInt32() == Pipe.Ready)
                return child;
        }
        catch (IOException)
        {
            // it has reported the reason
        }

        string why = child.LastWords.Split('\n')[0].Trim();
        child.Dispose();
        throw new InvalidOperationException("the process for scripts does not start: " + why);
    }

    /// <summary>Kills it at once; a reader of its output then finds the end.</summary>
    public void Kill()
    {
        try
        {
            _process.Kill(entireProcessTree: true);
        }
        catch (Exception ended) when (ended is InvalidOperationException or System.ComponentModel.Win32Exception)
        {
            // it has already ended
        }
    }

    public void Dispose()
    {
        AppDomain.CurrentDomain.ProcessExit -= End;
        foreach (PosixSignalRegistration signal in _signals)
            signal.Dispose();

        Kill();
        _process.WaitForExit();
        _process.Dispose();
        TakeAwayFolder();
    }

    private void End(object? sender, EventArgs e) => End();

    private void End()
    {
        Kill();
        TakeAwayFolder();
    }

    private void TakeAwayFolder()
    {
        try
        {
            _folder.Delete(recursive: true);
        }
        catch (Exception left) when (left is IOException or UnauthorizedAccessException)
        {
            // the child has deleted it, or another program has it open: it is empty
        }
    }

    private static string Assembly => Path.Combine(AppContext.BaseDirectory, "MyRigidbody.Scripts.dll");

    private static (string File, string[] Arguments) Program() =>
        IsThisProgram ? (Environment.ProcessPath!, [Server.Command]) : (Dotnet(), ["exec", Assembly, Server.Command]);

    // the runtime of this process knows its own host, however this process was started
    private static string Dotnet()
    {
        string host = Path.GetFullPath(Path.Combine(RuntimeEnvironment.GetRuntimeDirectory(), "../../..", OperatingSystem.IsWindows() ? "dotnet.exe" : "dotnet"));
        return File.Exists(host) ? host : "dotnet";
    }

    private void Note(string? line)
    {
        lock (_error)
        {
            if (line != null && _error.Length < MostErrorText)
                _error.AppendLine(line);
        }
    }
}
