using System.Text.Json;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>The assembly definitions: their fields are known to 2019.4, their names are unique, their references exist.</summary>
internal static class Assemblies
{
    private static readonly string[] Known =
    [
        "name", "references", "includePlatforms", "excludePlatforms", "allowUnsafeCode", "overrideReferences", "precompiledReferences",
        "autoReferenced", "defineConstraints", "versionDefines", "noEngineReferences",
    ];

    // what a student gets to write in: scripts without an assembly of their own, as his own scripts are
    private const string Starter = ProjectFiles.Assets + "/MyRigidbodyStarter/";

    // what the test framework brings
    private static readonly string[] Others = ["UnityEngine.TestRunner", "UnityEditor.TestRunner"];

    // assemblies of packages that a project may have or not, and the packages
    private static readonly Dictionary<string, string> Optional = new() { ["Unity.InputSystem"] = "com.unity.inputsystem" };

    /// <summary>What is wrong.</summary>
    public static IEnumerable<string> Findings(ProjectFiles files)
    {
        Dictionary<string, string> names = [];
        List<(string Path, JsonElement Root)> definitions = [];
        foreach ((string path, string text) in files.Texts.Where(file => file.Key.EndsWith(".asmdef", StringComparison.Ordinal)))
        {
            if (Parsed(text) is not JsonElement { ValueKind: JsonValueKind.Object } root || !root.TryGetProperty("name", out JsonElement name))
            {
                yield return $"{path}: is not a JSON object with a name";
                continue;
            }

            definitions.Add((path, root));
            if (name.GetString() != Path.GetFileNameWithoutExtension(path))
                yield return $"{path}: is called {name}, unlike its file";

            if (!names.TryAdd(name.GetString()!, path))
                yield return $"{path}: has the name of {names[name.GetString()!]}";
        }

        foreach ((string path, JsonElement root) in definitions)
        {
            foreach (string unknown in root.EnumerateObject().Select(field => field.Name).Except(Known))
                yield return $"{path}: {unknown} is not known to Unity 2019.4";

            foreach (string missing in Texts(root, "references").Except(names.Keys).Except(Others).Except(Optional.Keys))
                yield return $"{path}: refers to {missing}, which is no assembly here";

            foreach (string optional in Texts(root, "references").Where(reference => Optional.ContainsKey(reference) && !IsLeftOutWithout(Optional[reference], root)))
                yield return $"{path}: refers to {optional}, and is not left out where {Optional[optional]} is missing";

            if (Texts(root, "includePlatforms").Length > 0 && Texts(root, "excludePlatforms").Length > 0)
                yield return $"{path}: includes and excludes platforms";
        }

        string[] folders = [.. definitions.Select(definition => definition.Path[..(definition.Path.LastIndexOf('/') + 1)])];
        foreach (string script in files.Texts.Keys.Where(path => path.EndsWith(".cs", StringComparison.Ordinal)))
        {
            bool isStudents = script.StartsWith(Starter, StringComparison.Ordinal) && !script.Contains("/Editor/", StringComparison.Ordinal);
            if (isStudents == folders.Any(folder => script.StartsWith(folder, StringComparison.Ordinal)))
                yield return isStudents ? $"{script}: must be in no assembly of ours" : $"{script}: is in no assembly of ours";
        }
    }

    // a symbol that the package's version defines, and that the assembly cannot do without
    private static bool IsLeftOutWithout(string package, JsonElement root) =>
        root.TryGetProperty("versionDefines", out JsonElement defines)
        && defines.EnumerateArray().Where(define => define.GetProperty("name").GetString() == package)
            .Select(define => define.GetProperty("define").GetString()).Intersect(Texts(root, "defineConstraints")).Any();

    private static JsonElement? Parsed(string json)
    {
        try
        {
            return JsonDocument.Parse(json).RootElement;
        }
        catch (JsonException)
        {
            return null;
        }
    }

    private static string[] Texts(JsonElement root, string field) =>
        root.TryGetProperty(field, out JsonElement list) ? [.. list.EnumerateArray().Select(entry => entry.GetString()!)] : [];
}
