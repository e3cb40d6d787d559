using System.IO;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics.Engine
{
    /// <summary>The folder of the repository: the first above the test assembly, or else above this file, that holds the solution.</summary>
    internal static class Root
    {
        public static string Path { get; } =
            Above(System.AppContext.BaseDirectory) ?? Above(ThisFile()) ?? throw new DirectoryNotFoundException("no MyRigidbody.sln");

        private static string Above(string start)
        {
            DirectoryInfo folder = new DirectoryInfo(start);
            while (folder != null && !File.Exists(System.IO.Path.Combine(folder.FullName, "MyRigidbody.sln")))
                folder = folder.Parent;

            return folder?.FullName;
        }

        private static string ThisFile([CallerFilePath] string path = "") => path;
    }
}
