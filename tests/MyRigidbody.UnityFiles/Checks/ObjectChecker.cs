using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Whether an object has the fields that Unity 2019.4 writes, in that order, each with a value of its kind.</summary>
internal sealed class ObjectChecker(UnityFile file, Project project)
{
    private readonly References _references = new(file, project);

    /// <summary>What is wrong with it.</summary>
    public IEnumerable<string> Findings(UnityObject o)
    {
        if (Layouts.Of(o.ClassId) is not (string typeName, YamlMappingNode fields))
            return [$"class {o.ClassId} is none that the project should have"];

        return typeName == o.TypeName
            ? Mapping(o.Fields, [.. fields.Children.SelectMany(field => field.Key.Text() == "..." ? OfScript(o) : [field])], typeName)
            : [$"class {o.ClassId} is {typeName}, not {o.TypeName}"];
    }

    private IEnumerable<KeyValuePair<YamlNode, YamlNode>> OfScript(UnityObject o) =>
        o["m_Script"] is YamlMappingNode reference && reference.Children.ContainsKey("guid") && project.ScriptOf(reference.Field("guid").Text()) is Script script
            ? script.Fields.Select(field => KeyValuePair.Create<YamlNode, YamlNode>(field.Name, project.Scripts.KindOf(field.Type) ?? "unknown " + field.Type))
            : [];

    private IEnumerable<string> Node(YamlNode value, YamlNode kind, string where) => kind switch
    {
        YamlMappingNode { Children.Count: 0 } => IsEmpty(value as YamlMappingNode) ? [] : [$"{where}: should be {{}}"],
        YamlMappingNode fields => value is YamlMappingNode mapping ? Mapping(mapping, [.. fields.Children], where) : [$"{where}: is not a group of fields"],
        YamlSequenceNode kinds => value is YamlSequenceNode list ? List(list, kinds, where) : [$"{where}: is not a list"],
        _ => Single(value, kind.Text(), where),
    };

    private IEnumerable<string> Mapping(YamlMappingNode found, KeyValuePair<YamlNode, YamlNode>[] wanted, string where)
    {
        string[] names = [.. found.Children.Select(field => field.Key.Text())], should = [.. wanted.Select(field => field.Key.Text())];
        foreach (string missing in should.Except(names))
            yield return $"{where}: lacks {missing}";

        foreach (string other in names.Except(should))
            yield return $"{where}: has {other}, which Unity 2019.4 does not write";

        if (!names.Intersect(should).SequenceEqual(should.Intersect(names)))
            yield return $"{where}: its fields stand in another order than Unity 2019.4 writes them";

        foreach ((YamlNode name, YamlNode kind) in wanted.Where(field => names.Contains(field.Key.Text())))
        {
            foreach (string finding in Node(found.Children[name], kind, $"{where}.{name}"))
                yield return finding;
        }
    }

    // one kind in a list stands for any number of elements, several for just so many
    private IEnumerable<string> List(YamlSequenceNode found, YamlSequenceNode kinds, string where)
    {
        if (kinds.Children.Count != 1 && kinds.Children.Count != found.Children.Count)
            return [$"{where}: has {found.Children.Count} elements, not {kinds.Children.Count}"];

        return found.Children.SelectMany((value, i) => Node(value, kinds.Children[kinds.Children.Count == 1 ? 0 : i], $"{where}[{i}]"));
    }

    private IEnumerable<string> Single(YamlNode value, string kind, string where)
    {
        if (kind.StartsWith("unknown ", StringComparison.Ordinal))
            return [$"{where}: the checker does not know how Unity writes a field of type {kind[8..]}"];

        string? finding = Kinds.Fits(value, kind) switch
        {
            true => null,
            false => $"{value} is not {kind}",
            null => _references.Finding(value, kind),
        };
        return finding == null ? [] : [$"{where}: {finding}"];
    }

    private static bool IsEmpty(YamlMappingNode? mapping) => mapping is { Children.Count: 0 };
}
