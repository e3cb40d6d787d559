using System.Text.RegularExpressions;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>What files of a project may refer to: its assets by their GUIDs, and its scripts.</summary>
internal sealed partial class Project
{
    private readonly Dictionary<string, string> _assets = [];
    private readonly Lazy<Scripts> _scripts;

    public Project(ProjectFiles files)
    {
        Files = files;
        foreach ((string path, string text) in files.Texts.Where(file => ProjectFiles.IsMeta(file.Key)))
        {
            if (GuidIn(text) is string guid)
                _assets.TryAdd(guid, path[..^".meta".Length]);
        }

        _scripts = new Lazy<Scripts>(() => new Scripts(files));
    }

    public ProjectFiles Files { get; }

    public Scripts Scripts => _scripts.Value;

    /// <summary>The asset with a GUID; null if there is none.</summary>
    public string? Asset(string guid) => _assets.GetValueOrDefault(guid);

    /// <summary>The class of the script with a GUID; null if there is none that Unity would find.</summary>
    public Script? ScriptOf(string guid) => Asset(guid) is string path ? Scripts.In(path) : null;

    /// <summary>The GUID in a meta; null if it has none as Unity writes it.</summary>
    public static string? GuidIn(string meta) => GuidLine().Match(meta) is { Success: true } found ? found.Groups[1].Value : null;

    [GeneratedRegex(@"\AfileFormatVersion: 2\nguid: ([0-9a-f]{32})\n")]
    private static partial Regex GuidLine();
}
