using System.Globalization;
using RigidBodyDynamics.UnityFiles;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>An object of a scene with its components, by the names of their classes or scripts.</summary>
internal sealed class SceneObject
{
    private static readonly string[] Scripts = [.. Change.Real.Texts.Keys
        .Where(key => key.StartsWith(Change.Sources, StringComparison.Ordinal) && key.EndsWith(".cs", StringComparison.Ordinal))];

    private readonly Dictionary<string, UnityObject> _components;

    private SceneObject(string name, Dictionary<string, UnityObject> components)
    {
        Name = name;
        _components = components;
    }

    public string Name { get; }

    public Vector3d Position => Vector(this["Transform"]!["m_LocalPosition"]!);

    public Vector3d Scale => Vector(this["Transform"]!["m_LocalScale"]!);

    /// <summary>A component; null if there is none.</summary>
    public UnityObject? this[string component] => _components.GetValueOrDefault(component);

    /// <summary>The objects at the root of a scene, in the order of its hierarchy.</summary>
    public static SceneObject[] All(string path)
    {
        UnityFile file = UnityFile.Parse(path, Change.Text(path));
        return [.. file.Objects.Where(o => o.TypeName == "GameObject")
            .Select(owner => new SceneObject(owner["m_Name"]!.Text(), file.Objects.Where(o => o["m_GameObject"]?.FileId() == owner.FileId).ToDictionary(ClassOf)))
            .Where(found => found["Transform"]!["m_Father"]!.FileId() == 0)
            .OrderBy(found => int.Parse(found["Transform"]!["m_RootOrder"]!.Text(), CultureInfo.InvariantCulture))];
    }

    /// <summary>{x: , y: , z: }.</summary>
    public static Vector3d Vector(YamlNode node)
    {
        double Part(string axis) => double.Parse(node.Field(axis).Text(), CultureInfo.InvariantCulture);
        return new Vector3d(Part("x"), Part("y"), Part("z"));
    }

    private static string ClassOf(UnityObject component) => component.TypeName == "MonoBehaviour"
        ? Path.GetFileNameWithoutExtension(Scripts.Single(script => component["m_Script"]!.Field("guid").Text() == Change.Guid(script)))
        : component.TypeName;
}
