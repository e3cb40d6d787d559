using System.Globalization;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>What Unity 2019.4 writes of each class: Layouts.yaml, where the signs are explained.</summary>
internal static class Layouts
{
    private static readonly Dictionary<int, (string TypeName, YamlMappingNode Fields)> All = Read();

    /// <summary>Unity's numbers of the classes.</summary>
    public static IEnumerable<int> Known => All.Keys;

    /// <summary>The name and the fields of a class; null if the project should have none of it.</summary>
    public static (string TypeName, YamlMappingNode Fields)? Of(int classId) =>
        All.TryGetValue(classId, out (string TypeName, YamlMappingNode Fields) found) ? found : null;

    private static Dictionary<int, (string TypeName, YamlMappingNode Fields)> Read()
    {
        using StreamReader text = new(typeof(Layouts).Assembly.GetManifestResourceStream("Layouts.yaml")!);
        YamlStream yaml = [];
        yaml.Load(text);
        return ((YamlMappingNode)yaml.Documents[0].RootNode).Children.ToDictionary(
            pair => int.Parse(pair.Key.Text().Split(' ')[1], CultureInfo.InvariantCulture),
            pair => (pair.Key.Text().Split(' ')[0], (YamlMappingNode)pair.Value));
    }
}
