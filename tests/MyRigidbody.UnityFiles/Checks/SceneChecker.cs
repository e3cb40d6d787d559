using System.Numerics;
using System.Runtime.CompilerServices;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Errors in a scene, material or settings file; every finding is a line that names file and object.</summary>
internal sealed class SceneChecker(string path, Project project)
{
    // occlusion culling, render, light map and navigation settings
    private static readonly int[] SettingsOfAScene = [29, 104, 157, 196];

    // copies of a project share the texts in which they do not differ
    private static readonly ConditionalWeakTable<string, UnityFile> Parsed = [];

    /// <summary>What is wrong.</summary>
    public IEnumerable<string> Findings()
    {
        string text = project.Files.Texts[path];
        if (text.Contains('\r') || text.Contains('\t') || text.StartsWith('\uFEFF') || !text.EndsWith('\n'))
            return [$"{path}: has a carriage return, a tab or a byte order mark, or no line feed at its end"];

        try
        {
            return Findings(Parsed.GetValue(text, found => UnityFile.Parse(path, found)));
        }
        catch (Exception wrong) when (wrong is FormatException or OverflowException)
        {
            return [wrong.Message.StartsWith(path, StringComparison.Ordinal) ? wrong.Message : $"{path}: {wrong.Message}"];
        }
    }

    private List<string> Findings(UnityFile file)
    {
        ObjectChecker objects = new(file, project);
        List<string> findings = [];
        foreach (UnityObject o in file.Objects)
            findings.AddRange(objects.Findings(o).Select(finding => Line(file, o, finding)));

        foreach (IGrouping<long, UnityObject> same in file.Objects.GroupBy(o => o.FileId).Where(group => group.Key == 0 || group.Count() > 1))
            findings.Add($"{path}: {same.Count()} objects are &{same.Key}");

        if (!path.EndsWith(".unity", StringComparison.Ordinal))
            return findings;

        findings.AddRange(Whole(file));
        findings.AddRange(new Hierarchy(file).Findings().Select(found => Line(file, found.Object, found.Finding)));
        ILookup<long, UnityObject> components = file.Objects.ToLookup(OwnerOf);
        findings.AddRange(file.Objects.Where(o => o.TypeName == "GameObject")
            .SelectMany(o => Together([.. components[o.FileId]]).Select(finding => Line(file, o, finding))));
        findings.AddRange(file.Objects.Where(o => o.TypeName == "Transform" && !AnglesAgree(o))
            .Select(o => Line(file, o, "m_LocalRotation is not the rotation of m_LocalEulerAnglesHint")));
        return findings;
    }

    private IEnumerable<string> Whole(UnityFile file)
    {
        if (!file.Objects.Take(4).Select(o => (o.FileId, o.ClassId)).SequenceEqual(SettingsOfAScene.Select((id, i) => (i + 1L, id))))
            yield return $"{path}: must begin with the settings &1 to &4, of classes {string.Join(", ", SettingsOfAScene)}";

        if (file.Objects.Zip(file.Objects.Skip(1)).Any(pair => pair.First.FileId > pair.Second.FileId))
            yield return $"{path}: objects do not stand in the order of their fileIDs";

        UnityObject[] cameras = [.. file.Objects.Where(o => o.TypeName == "Camera")];
        if (cameras.Length != 1 || (Owner(file, cameras[0])?["m_TagString"] as YamlScalarNode)?.Value != "MainCamera")
            yield return $"{path}: has {cameras.Length} cameras; there must be one, tagged MainCamera";

        if (file.Objects.Count(o => (o["m_TagString"] as YamlScalarNode)?.Value == "MainCamera") > 1)
            yield return $"{path}: more than one object is tagged MainCamera";

        int listeners = file.Objects.Count(o => o.TypeName == "AudioListener");
        if (listeners != 1)
            yield return $"{path}: has {listeners} audio listeners; Unity wants one";
    }

    /// <summary>Requirements of scripts for other components of the same object.</summary>
    private IEnumerable<string> Together(UnityObject[] components)
    {
        Script[] scripts = [.. components.Select(ScriptOf).OfType<Script>()];
        HashSet<string> names = [.. components.Select(o => o.TypeName), .. scripts.Select(script => script.Name)];
        foreach (Script script in scripts)
        {
            foreach (string missing in script.Needs.Where(needed => !names.Contains(needed)))
                yield return $"has a {script.Name} but no {missing}, which it requires";
        }

        foreach (IGrouping<string, Script> same in scripts.Where(script => script.IsAlone).GroupBy(script => script.Name).Where(group => group.Count() > 1))
            yield return $"has {same.Count()} of {same.Key}, which stands alone";

        foreach (IGrouping<string, UnityObject> same in components.Where(o => o.TypeName != "MonoBehaviour").GroupBy(o => o.TypeName).Where(group => group.Count() > 1))
            yield return $"has {same.Count()} of {same.Key}";

        foreach (UnityObject lost in components.Where(o => o.TypeName == "MonoBehaviour" && ScriptOf(o) == null))
            yield return $"&{lost.FileId} has no script that Unity would find: its file has no component of its name";
    }

    private Script? ScriptOf(UnityObject o) =>
        o["m_Script"] is YamlMappingNode script && script.Children.ContainsKey("guid") ? project.ScriptOf(script.Field("guid").Text()) : null;

    // turned about z first, then x, then y
    private static bool AnglesAgree(UnityObject transform)
    {
        if (transform["m_LocalRotation"] is not YamlMappingNode { Children.Count: 4 } rotation
            || transform["m_LocalEulerAnglesHint"] is not YamlMappingNode { Children.Count: 3 } hint)
        {
            return true;
        }

        Vector3 angles = hint.Vector() * MathF.PI / 180;
        return Math.Abs(Quaternion.Dot(Quaternion.CreateFromYawPitchRoll(angles.Y, angles.X, angles.Z), rotation.Rotation())) > 1 - 1e-6;
    }

    private static long OwnerOf(UnityObject component) => component["m_GameObject"] is YamlMappingNode { Children.Count: 1 } reference ? reference.FileId() : 0;

    private static UnityObject? Owner(UnityFile file, UnityObject component)
    {
        long owner = OwnerOf(component);
        return file.Objects.FirstOrDefault(o => o.FileId == owner);
    }

    private string Line(UnityFile file, UnityObject o, string finding)
    {
        UnityObject owner = Owner(file, o) ?? o;
        string name = owner["m_Name"] is YamlScalarNode { Value: { Length: > 0 } text } ? $" of '{text}'" : string.Empty;
        return $"{path}: {o.TypeName} &{o.FileId}{name}: {finding}";
    }
}
