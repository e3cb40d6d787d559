using System.Collections.Concurrent;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>Waits for a file to be saved.</summary>
internal static class Saves
{
    // an editor may write a file in several parts
    private static readonly TimeSpan Quiet = TimeSpan.FromMilliseconds(150);

    /// <summary>True after every save that changed the content, without end.</summary>
    public static IEnumerable<bool> Of(string path)
    {
        string full = Path.GetFullPath(path);
        using BlockingCollection<bool> changes = [];
        using FileSystemWatcher watcher = new(Path.GetDirectoryName(full)!, Path.GetFileName(full));
        // some editors write another file and rename it
        watcher.Changed += (_, _) => changes.Add(true);
        watcher.Created += (_, _) => changes.Add(true);
        watcher.Renamed += (_, _) => changes.Add(true);
        watcher.EnableRaisingEvents = true;
        byte[] last = Content(full);
        while (true)
        {
            changes.Take();
            while (changes.TryTake(out _, Quiet))
            {
                // until no change comes for a while
            }

            byte[] now = Content(full);
            if (now.Length == 0 || now.AsSpan().SequenceEqual(last))
                continue;

            last = now;
            yield return true;
        }
    }

    // empty while the file is absent or being written
    private static byte[] Content(string path)
    {
        try
        {
            return InputFile.Bytes(path).ToArray();
        }
        catch (InputException)
        {
            return [];
        }
    }
}
