using System.Text.Json;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>The editor's version and what the project takes from elsewhere.</summary>
internal static partial class Packages
{
    private const string Manifest = ProjectFiles.Project + "/Packages/manifest.json", Version = ProjectFiles.Project + "/ProjectSettings/ProjectVersion.txt";
    private const string Editor = "m_EditorVersion: 2019.4.17f1\nm_EditorVersionWithRevision: 2019.4.17f1 (667c8606c536)\n";

    // the parts of the engine that the scripts and scenes use
    private static readonly string[] Modules = ["audio", "imgui", "physics"];

    /// <summary>What is wrong.</summary>
    public static IEnumerable<string> Findings(ProjectFiles files)
    {
        if (files.Texts.GetValueOrDefault(Version) != Editor)
            yield return $"{Version}: must have the two lines of 2019.4.17f1";

        Dictionary<string, string>? packages = Dependencies(files.Texts.GetValueOrDefault(Manifest, "{}"));
        if (packages == null)
        {
            yield return $"{Manifest}: is not a JSON object with dependencies";
            yield break;
        }

        foreach (string missing in Modules.Select(module => "com.unity.modules." + module).Except(packages.Keys))
            yield return $"{Manifest}: lacks {missing}, which the scenes need";

        foreach ((string name, string version) in packages)
        {
            if (version.StartsWith("file:", StringComparison.Ordinal))
            {
                foreach (string finding in Local(files, name, version["file:".Length..]))
                    yield return $"{Manifest}: {name}: {finding}";
            }
            else if (!Number().IsMatch(version))
            {
                yield return $"{Manifest}: {name}: {version} is not a version";
            }
        }
    }

    // a path from the folder of the manifest, with forward slashes
    private static IEnumerable<string> Local(ProjectFiles files, string name, string path)
    {
        string folder = path.StartsWith("../../", StringComparison.Ordinal) ? path["../../".Length..] : string.Empty;
        if (!files.Texts.TryGetValue(folder + "/package.json", out string? text))
        {
            yield return $"there is no package at {path}";
            yield break;
        }

        using JsonDocument package = JsonDocument.Parse(text);
        if (package.RootElement.GetProperty("name").GetString() != name)
            yield return $"the package at {path} is called {package.RootElement.GetProperty("name")}";

        // the editor refuses a whole version like 2019.4.17f1
        if (!package.RootElement.TryGetProperty("unity", out JsonElement unity) || unity.GetString() != "2019.4")
            yield return $"the package at {path} must say \"unity\": \"2019.4\"";
    }

    private static Dictionary<string, string>? Dependencies(string json)
    {
        try
        {
            return JsonDocument.Parse(json).RootElement.GetProperty("dependencies").Deserialize<Dictionary<string, string>>();
        }
        catch (Exception wrong) when (wrong is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            return null;
        }
    }

    [GeneratedRegex(@"^\d+\.\d+\.\d+$")]
    private static partial Regex Number();
}
