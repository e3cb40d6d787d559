using System.Runtime.InteropServices;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>Rights that a child gives up before it reads a script: where the system supports such limits, it can write no file.</summary>
internal static partial class Rights
{
    // the same numbers on Linux and macOS
    private const int FileSize = 1, Core = 4;

    public static void GiveUp()
    {
        if (OperatingSystem.IsLinux() || OperatingSystem.IsMacOS())
        {
            Set(FileSize);
            Set(Core);
        }
    }

    // zero for the soft and the hard limit, so that it cannot be raised again
    private static void Set(int resource) => _ = SetLimit(resource, default);

    [LibraryImport("libc", EntryPoint = "setrlimit")]
    private static partial int SetLimit(int resource, in Limit limit);

    [StructLayout(LayoutKind.Sequential)]
    private readonly struct Limit
    {
        private readonly ulong _now, _most;
    }
}
