using System.Runtime.InteropServices.JavaScript;
using System.Runtime.Versioning;
using RigidBodyDynamics.Lab;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Play;

/// <summary>What the page asks of the simulation.</summary>
internal static partial class Live
{
    private static void Main()
    {
    }

    /// <summary>The name of the scene in the text of a scene file; what is wrong with it becomes an error of one line.</summary>
    [JSExport]
    internal static string NameOf(string file, string text)
    {
        File.WriteAllText(file, text);
        return SceneReader.Read(file).Scene.Name;
    }
}
