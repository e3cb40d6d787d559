using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Play;

/// <summary>The runtime asks for a start; everything else is asked for by the page.</summary>
internal static class Program
{
    private static void Main()
    {
    }
}
