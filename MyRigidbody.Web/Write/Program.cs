using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Write;

/// <summary>The program of the worker, which only answers calls.</summary>
internal static class Program
{
    // output of scripts is discarded
    private static void Main() => Console.SetOut(TextWriter.Null);
}
