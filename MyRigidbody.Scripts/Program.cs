using RigidBodyDynamics.StudentScripts.Children;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>The process in which scripts of students are compiled and run; the command line starts it.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        if (args is [Server.Command])
            return Server.Run();

        Console.Error.WriteLine("error: this program is started by check and grade, and does nothing by itself");
        return 2;
    }
}
