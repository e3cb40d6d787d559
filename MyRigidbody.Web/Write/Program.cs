using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Write;

/// <summary>The program of the worker, which does nothing until it is asked.</summary>
internal static class Program
{
    // what scripts write goes nowhere
    private static void Main() => Console.SetOut(TextWriter.Null);
}
