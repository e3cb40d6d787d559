using System.Globalization;
using System.Numerics;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles;

/// <summary>Values as Unity writes them.</summary>
internal static class Values
{
    /// <summary>A field of a mapping; a mapping without it is not as Unity writes it.</summary>
    public static YamlNode Field(this YamlNode? mapping, string name) =>
        mapping is YamlMappingNode { Children: IDictionary<YamlNode, YamlNode> fields } && fields.TryGetValue(new YamlScalarNode(name), out YamlNode? found)
            ? found
            : throw new FormatException($"no field {name}");

    /// <summary>A text or number as written.</summary>
    public static string Text(this YamlNode node) => (node as YamlScalarNode)?.Value ?? throw new FormatException("not a single value");

    /// <summary>A number.</summary>
    public static float Number(this YamlNode node) => float.Parse(node.Text(), CultureInfo.InvariantCulture);

    /// <summary>{x: , y: , z: }.</summary>
    public static Vector3 Vector(this YamlNode node) => new(node.Field("x").Number(), node.Field("y").Number(), node.Field("z").Number());

    /// <summary>{x: , y: , z: , w: }.</summary>
    public static Quaternion Rotation(this YamlNode node) => new(node.Vector(), node.Field("w").Number());

    /// <summary>{r: , g: , b: , a: }, without a.</summary>
    public static Vector3 Color(this YamlNode node) => new(node.Field("r").Number(), node.Field("g").Number(), node.Field("b").Number());

    /// <summary>The number in {fileID: } of an object in the same file; 0 where there is none.</summary>
    public static long FileId(this YamlNode node) => long.Parse(node.Field("fileID").Text(), CultureInfo.InvariantCulture);

    /// <summary>The elements of a list.</summary>
    public static IList<YamlNode> List(this YamlNode node) => (node as YamlSequenceNode)?.Children ?? throw new FormatException("not a list");
}
