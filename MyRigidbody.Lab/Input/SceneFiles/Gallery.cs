namespace RigidBodyDynamics.Lab;

/// <summary>The scenes that are installed with the program.</summary>
internal static class Gallery
{
    /// <summary>The lab's own scene: a cube, the arrow keys and "r".</summary>
    public static string Lab => Path.Combine(Folder, "lab.json");

    /// <summary>The folder of all of them.</summary>
    public static string Folder => Path.Combine(AppContext.BaseDirectory, "scenes");
}
