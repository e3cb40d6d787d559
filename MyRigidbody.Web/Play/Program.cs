using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Play;

/// <summary>The runtime needs an entry point; the page calls everything else.</summary>
internal static class Program
{
    private static void Main()
    {
    }
}
