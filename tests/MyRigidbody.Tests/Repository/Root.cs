using System.Runtime.CompilerServices;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The folder of the repository: the first above the test assembly, or else above this file, that holds the solution.</summary>
internal static class Root
{
    public static string Path { get; } = Above(AppContext.BaseDirectory) ?? Above(ThisFile()) ?? throw new DirectoryNotFoundException("no MyRigidbody.sln");

    /// <summary>A file or folder in it.</summary>
    public static string File(string relative) => System.IO.Path.Combine(Path, relative);

    private static string? Above(string start)
    {
        DirectoryInfo? folder = new(start);
        while (folder != null && !System.IO.File.Exists(System.IO.Path.Combine(folder.FullName, "MyRigidbody.sln")))
            folder = folder.Parent;

        return folder?.FullName;
    }

    private static string ThisFile([CallerFilePath] string path = "") => path;
}
