using System.Runtime.InteropServices;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>Writes files whole or not at all: beside their place first, then moved into it.</summary>
internal sealed class Files : IDisposable
{
    private readonly string _folder;
    private readonly string _name;
    private readonly List<(string Temporary, string Final)> _written = [];
    private readonly List<PosixSignalRegistration> _signals = [];

    /// <summary>Files for a folder, which is made if it is not there.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">How the user called what is to be written; named in errors.</param>
    public Files(string folder, string name)
    {
        _name = name.Length > 0 ? name : throw new InputException("--out: must not be empty");
        _folder = Path.GetFullPath(folder);
        if (_folder == "/dev")
        {
            // a file moved into the place of a device would take it from everybody
            throw new InputException($"{name}: is a device; without --out the trajectory goes to standard output");
        }

        Try(() => Directory.CreateDirectory(_folder));
        // a file that is half written goes with the process that wrote it
        foreach (PosixSignal signal in new[] { PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP })
        {
            _signals.Add(PosixSignalRegistration.Create(signal, _ => TakeAway()));
        }

        AppDomain.CurrentDomain.ProcessExit += (_, _) => TakeAway();
    }

    /// <summary>Writes one file, by a function that is given the path to write to.</summary>
    public void Write(string fileName, Action<string> write)
    {
        string temporary = Path.Combine(_folder, "." + Guid.NewGuid().ToString("N") + Path.GetExtension(fileName));
        _written.Add((temporary, Path.Combine(_folder, fileName)));
        Try(() => write(temporary));
    }

    /// <summary>Puts all files in their places.</summary>
    public void Keep()
    {
        foreach ((string _, string final) in _written)
        {
            if (Directory.Exists(final))
            {
                throw new InputException($"{_name}: is a folder, and a file of this name is to be written");
            }
        }

        Try(() => _written.ForEach(file => File.Move(file.Temporary, file.Final, overwrite: true)));
        _written.Clear();
    }

    /// <summary>Takes away what was not kept.</summary>
    public void Dispose()
    {
        _signals.ForEach(signal => signal.Dispose());
        TakeAway();
    }

    private void TakeAway()
    {
        try
        {
            foreach ((string temporary, string _) in _written)
            {
                File.Delete(temporary);
            }
        }
        catch (Exception left) when (left is IOException or UnauthorizedAccessException)
        {
            // the folder has gone or was closed: that is why nothing was kept, and it has been said
        }
    }

    private void Try(Action action)
    {
        try
        {
            action();
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"{_name}: cannot be written: {problem.Message.ReplaceLineEndings(" ")}");
        }
    }
}
