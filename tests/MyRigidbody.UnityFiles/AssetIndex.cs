using System.Text.RegularExpressions;

namespace RigidBodyDynamics.UnityFiles;

/// <summary>Which asset has which GUID, by the metas of some folders.</summary>
public sealed partial class AssetIndex
{
    private readonly Dictionary<string, string> _paths = [];

    /// <summary>The assets of some folders, hidden ones left out.</summary>
    /// <exception cref="FormatException">A meta has no GUID, or one that another has.</exception>
    public AssetIndex(params IEnumerable<string> folders)
    {
        foreach (string meta in folders.SelectMany(folder => Directory.EnumerateFiles(folder, "*.meta", SearchOption.AllDirectories)))
        {
            Match guid = GuidLine().Match(File.ReadAllText(meta));
            if (!guid.Success)
                throw new FormatException($"{meta}: has no GUID of 32 lower-case hex digits");

            if (!_paths.TryAdd(guid.Groups[1].Value, meta[..^".meta".Length]))
                throw new FormatException($"{meta}: has the GUID of {_paths[guid.Groups[1].Value]}");
        }
    }

    /// <summary>All GUIDs and the assets they stand for.</summary>
    public IReadOnlyDictionary<string, string> Paths => _paths;

    /// <summary>The asset with a GUID; null if there is none.</summary>
    public string? Find(string guid) => _paths.GetValueOrDefault(guid);

    [GeneratedRegex(@"^guid: ([0-9a-f]{32})$", RegexOptions.Multiline)]
    private static partial Regex GuidLine();
}
