using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>All errors that an editor would report in the Unity project, as far as they can be found without one.</summary>
public static class ProjectChecker
{
    private const string Settings = ProjectFiles.Project + "/ProjectSettings/", BuildSettings = Settings + "EditorBuildSettings.asset";

    // an editor adds a dozen others, in which nothing matters here
    private static readonly string[] OurSettings =
        [Settings + "DynamicsManager.asset", BuildSettings, Settings + "EditorSettings.asset", Settings + "TimeManager.asset"];

    /// <summary>What is wrong, one line each, naming the file and, where there is one, the object.</summary>
    public static IReadOnlyList<string> Findings(ProjectFiles files)
    {
        Project project = new(files);
        return
        [
            .. Metas.Findings(files, ProjectFiles.Assets, ProjectFiles.Package, ProjectFiles.Judge),
            .. Assemblies.Findings(files),
            .. Packages.Findings(files),
            .. project.Scripts.Misnamed,
            .. Shaders.Findings(project),
            .. OurSettings.Where(path => !files.Texts.ContainsKey(path)).Select(path => $"{path}: is missing"),
            .. files.Texts.Keys.Where(IsYaml).SelectMany(path => new SceneChecker(path, project).Findings()),
            .. ScenesToBuild(project),
        ];
    }

    private static bool IsYaml(string path) => path.StartsWith(Settings, StringComparison.Ordinal)
        ? OurSettings.Contains(path)
        : Path.GetExtension(path) is ".unity" or ".mat" or ".asset" or ".prefab" or ".physicMaterial";

    private static IEnumerable<string> ScenesToBuild(Project project)
    {
        if (!project.Files.Texts.TryGetValue(BuildSettings, out string? text) || Listed(text) is not (string Path, string Guid)[] listed)
            yield break;

        foreach ((string path, string guid) in listed)
        {
            if (!project.Files.Texts.ContainsKey(ProjectFiles.Project + "/" + path))
                yield return $"{BuildSettings}: lists {path}, which is not there";
            else if (project.Asset(guid) != ProjectFiles.Project + "/" + path)
                yield return $"{BuildSettings}: {path} has another GUID than {guid}";
        }

        IEnumerable<string> scenes = project.Files.Texts.Keys.Where(path => path.EndsWith(".unity", StringComparison.Ordinal));
        foreach (string left in scenes.Except(listed.Select(scene => ProjectFiles.Project + "/" + scene.Path)))
            yield return $"{BuildSettings}: does not list {left}";
    }

    // null where the file is invalid, which is another finding
    private static (string Path, string Guid)[]? Listed(string text)
    {
        try
        {
            YamlNode scenes = UnityFile.Parse(BuildSettings, text).Objects[0]["m_Scenes"]!;
            return [.. scenes.List().Select(scene => (scene.Field("path").Text(), scene.Field("guid").Text()))];
        }
        catch (Exception wrong) when (wrong is FormatException or ArgumentException or NullReferenceException)
        {
            return null;
        }
    }
}
