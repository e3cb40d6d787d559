using System.Runtime.InteropServices;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>Writes files completely or not at all: temporary ones first, then moved into place.</summary>
internal sealed class Files : IDisposable
{
    private readonly string _folder;
    private readonly string _name;
    private readonly string[] _inputs;
    private readonly List<(string Temporary, string Final)> _written = [];
    private readonly List<string> _made = [];
    private readonly List<PosixSignalRegistration> _signals = [];

    /// <summary>Files for a folder, which is created if it does not exist.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">The option or argument that named the output; used in errors.</param>
    /// <param name="inputs">The files that were read; none of them is overwritten.</param>
    public Files(string folder, string name, IEnumerable<string> inputs)
    {
        _inputs = [.. inputs];
        _name = name.Length > 0 ? name : throw new InputException("--out: must not be empty");
        _folder = Path.GetFullPath(folder);
        if (_folder == "/dev")
        {
            // a file moved over a device would remove the device
            throw new InputException($"{name}: is a device; without --out the trajectory goes to standard output");
        }

        Try(MakeFolder);
        // temporary files are removed when the process is stopped
        foreach (PosixSignal signal in new[] { PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP })
            _signals.Add(PosixSignalRegistration.Create(signal, _ => TakeAway()));

        AppDomain.CurrentDomain.ProcessExit += (_, _) => TakeAway();
    }

    /// <summary>Writes one file, by a function that gets the path.</summary>
    public void Write(string fileName, Action<string> write)
    {
        MustBeFree(fileName);
        string final = Path.Combine(_folder, fileName);
        string temporary = Path.Combine(_folder, "." + Guid.NewGuid().ToString("N") + Path.GetExtension(fileName));
        _written.Add((temporary, final));
        Try(() => write(temporary));
    }

    /// <summary>Moves all files into place.</summary>
    public void Keep()
    {
        Try(() => _written.ForEach(file => File.Move(file.Temporary, file.Final, overwrite: true)));
        _written.Clear();
        _made.Clear();
    }

    /// <summary>Throws where a file of this name must not be written.</summary>
    public void MustBeFree(string fileName) => Try(() => MustBeFree(fileName, Path.Combine(_folder, fileName)));

    /// <summary>Removes temporary files, and folders created for them.</summary>
    public void Dispose()
    {
        _signals.ForEach(signal => signal.Dispose());
        TakeAway();
    }

    private void MakeFolder()
    {
        for (string? missing = _folder; missing != null && !Directory.Exists(missing); missing = Path.GetDirectoryName(missing))
            _made.Add(missing);

        Directory.CreateDirectory(_folder);
    }

    /// <summary>Tests that the target is free, or a plain file that is not an input.</summary>
    private void MustBeFree(string fileName, string final)
    {
        string name = Path.GetFileName(_name) == fileName ? _name : Path.Combine(_name, fileName);
        if (Directory.Exists(final))
            throw new InputException($"{name}: is a folder, and a file of this name is to be written");

        if (Array.Find(_inputs, input => RealPath.Same(input, final)) is not null)
            throw new InputException($"{name}: is what was read, and would be written over");

        // a dangling link exists, too
        if ((File.Exists(final) || new FileInfo(final).LinkTarget != null) && !RealPath.IsPlainFile(final))
            throw new InputException($"{name}: is a link, a pipe or a device, and a file would take its place");
    }

    private void TakeAway()
    {
        try
        {
            foreach ((string temporary, string _) in _written)
                File.Delete(temporary);

            foreach (string folder in _made.Where(folder => Directory.Exists(folder) && !Directory.EnumerateFileSystemEntries(folder).Any()))
                Directory.Delete(folder);
        }
        catch (Exception left) when (left is IOException or UnauthorizedAccessException)
        {
            // the folder was removed or closed to us: this has been reported before
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
