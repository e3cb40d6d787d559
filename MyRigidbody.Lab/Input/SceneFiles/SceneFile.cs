namespace RigidBodyDynamics.Lab;

/// <summary>What a scene file or a recording describes.</summary>
/// <param name="Path">The file, as the user called it.</param>
/// <param name="Scene">The scene.</param>
/// <param name="Crowds">Bodies in numbers, by name; the scene has one of each.</param>
/// <param name="SolidBoxes">For bodies made of a box's vertices: the solid box, by name of the body; Unity's inertia.</param>
/// <param name="Recording">What was recorded, if the file is a recording.</param>
internal sealed record SceneFile(
    string Path,
    SceneDescription Scene,
    IReadOnlyDictionary<string, ManyBodies> Crowds,
    IReadOnlyDictionary<string, MassProperties> SolidBoxes,
    Recording? Recording)
{
    /// <summary>The meshes that it names.</summary>
    public IReadOnlyCollection<string> Meshes { get; init; } = [];

    /// <summary>What the user should know of a body, by its name.</summary>
    public IReadOnlyDictionary<string, IReadOnlyList<string>> Notes { get; init; } = new Dictionary<string, IReadOnlyList<string>>();

    /// <summary>The files it was read from.</summary>
    public IEnumerable<string> Inputs => Recording == null ? [Path, .. Meshes] : [Path, Recording.Path];
}
