namespace RigidBodyDynamics.Lab;

/// <summary>The content of a scene file or a recording.</summary>
/// <param name="Path">The file, as typed.</param>
/// <param name="Scene">The scene.</param>
/// <param name="Crowds">Bodies with a count, by name; the scene has one of each.</param>
/// <param name="SolidBoxes">For bodies made of a box's vertices: the solid box, by name of the body; Unity's inertia.</param>
/// <param name="Recording">The recorded motion, if the file is a recording.</param>
internal sealed record SceneFile(
    string Path,
    SceneDescription Scene,
    IReadOnlyDictionary<string, ManyBodies> Crowds,
    IReadOnlyDictionary<string, MassProperties> SolidBoxes,
    Recording? Recording)
{
    /// <summary>The meshes that it refers to.</summary>
    public IReadOnlyCollection<string> Meshes { get; init; } = [];

    /// <summary>Notes for the user about a body, by its name.</summary>
    public IReadOnlyDictionary<string, IReadOnlyList<string>> Notes { get; init; } = new Dictionary<string, IReadOnlyList<string>>();

    /// <summary>The files it was read from.</summary>
    public IEnumerable<string> Inputs => Recording == null ? [Path, .. Meshes] : [Path, Recording.Path];
}
