using System.Globalization;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Whether objects and their components, fathers and children say the same of each other.</summary>
internal sealed class Hierarchy(UnityFile file)
{
    private readonly Dictionary<long, UnityObject> _objects = file.Objects.DistinctBy(o => o.FileId).ToDictionary(o => o.FileId);

    /// <summary>What is wrong, and with which object.</summary>
    public IEnumerable<(UnityObject Object, string Finding)> Findings() =>
        [.. file.Objects.Where(o => o.TypeName == "GameObject").SelectMany(Components), .. file.Objects.SelectMany(Owner), .. Transforms(), .. Roots()];

    private IEnumerable<(UnityObject, string)> Components(UnityObject o)
    {
        long[] listed = [.. List(o, "m_Component").Select(entry => Id(entry, "component"))];
        UnityObject?[] found = [.. listed.Select(_objects.GetValueOrDefault)];
        if (found.FirstOrDefault()?.TypeName != "Transform" || found.Count(component => component?.TypeName == "Transform") != 1)
            yield return (o, "m_Component: has not one Transform, and that first");

        foreach (UnityObject component in found.OfType<UnityObject>().Where(component => Id(component["m_GameObject"]) != o.FileId))
            yield return (component, $"belongs to &{Id(component["m_GameObject"])}, but &{o.FileId} lists it");
    }

    private IEnumerable<(UnityObject, string)> Owner(UnityObject o)
    {
        if (o["m_GameObject"] == null || !_objects.TryGetValue(Id(o["m_GameObject"]), out UnityObject? owner))
            yield break;

        int times = List(owner, "m_Component").Count(entry => Id(entry, "component") == o.FileId);
        if (times != 1)
            yield return (o, $"its GameObject lists it {times} times");
    }

    private IEnumerable<(UnityObject, string)> Transforms()
    {
        foreach (UnityObject transform in file.Objects.Where(o => o.TypeName == "Transform"))
        {
            long father = Id(transform["m_Father"]);
            long[] children = [.. List(transform, "m_Children").Select(Id)];
            if (father != 0 && _objects.TryGetValue(father, out UnityObject? above) && !List(above, "m_Children").Select(Id).Contains(transform.FileId))
                yield return (transform, $"its father &{father} does not list it among its children");

            for (int i = 0; i < children.Length; i++)
            {
                if (!_objects.TryGetValue(children[i], out UnityObject? child))
                    continue;

                if (Id(child["m_Father"]) != transform.FileId)
                    yield return (transform, $"its child &{children[i]} has another father");

                if (RootOrder(child) != i)
                    yield return (child, $"m_RootOrder is {RootOrder(child)}, but it is child {i} of its father");
            }
        }
    }

    private IEnumerable<(UnityObject, string)> Roots()
    {
        UnityObject[] roots = [.. file.Objects.Where(o => o.TypeName == "Transform" && Id(o["m_Father"]) == 0).OrderBy(RootOrder)];
        for (int i = 0; i < roots.Length; i++)
        {
            if (RootOrder(roots[i]) != i)
                yield return (roots[i], $"m_RootOrder is {RootOrder(roots[i])}, where {i} is missing or taken twice");
        }
    }

    private static int RootOrder(UnityObject transform) =>
        int.TryParse((transform["m_RootOrder"] as YamlScalarNode)?.Value, CultureInfo.InvariantCulture, out int order) ? order : -1;

    private static IList<YamlNode> List(UnityObject o, string field) => (o[field] as YamlSequenceNode)?.Children ?? [];

    private static long Id(YamlNode entry, string field) =>
        entry is YamlMappingNode mapping && mapping.Children.TryGetValue(new YamlScalarNode(field), out YamlNode? reference) ? Id(reference) : 0;

    private static long Id(YamlNode? reference) =>
        reference is YamlMappingNode mapping && mapping.Children.TryGetValue(new YamlScalarNode("fileID"), out YamlNode? id)
        && long.TryParse((id as YamlScalarNode)?.Value, CultureInfo.InvariantCulture, out long number) ? number : 0;
}
