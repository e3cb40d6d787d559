using System.Globalization;
using System.Text.RegularExpressions;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles;

/// <summary>A scene, material or settings file as Unity writes it: one YAML document for every object.</summary>
public sealed partial class UnityFile
{
    private UnityFile(string path, IReadOnlyList<UnityObject> objects)
    {
        Path = path;
        Objects = objects;
    }

    /// <summary>The file.</summary>
    public string Path { get; }

    /// <summary>Its objects, in the order of the file.</summary>
    public IReadOnlyList<UnityObject> Objects { get; }

    public static UnityFile Read(string path) => Parse(path, File.ReadAllText(path));

    /// <summary>Reads the text of a file.</summary>
    /// <exception cref="FormatException">It is not as Unity writes it; the message names the file and the object.</exception>
    public static UnityFile Parse(string path, string text)
    {
        MatchCollection heads = Head().Matches(text);
        string preamble = heads.Count > 0 ? text[..heads[0].Index] : text;
        if (preamble != "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n")
            throw new FormatException($"{path}: must begin with %YAML 1.1 and %TAG !u! tag:unity3d.com,2011:, then --- !u!CLASS &FILE_ID");

        List<UnityObject> objects = [];
        for (int i = 0; i < heads.Count; i++)
        {
            // a YAML reader forgets the %TAG after the first document, so each is read alone, without its head
            int start = heads[i].Index + heads[i].Length, end = i + 1 < heads.Count ? heads[i + 1].Index : text.Length;
            objects.Add(Object(path, heads[i], text[start..end]));
        }

        return new UnityFile(path, objects);
    }

    private static UnityObject Object(string path, Match head, string body)
    {
        int classId = int.Parse(head.Groups[1].Value, CultureInfo.InvariantCulture);
        long fileId = long.Parse(head.Groups[2].Value, CultureInfo.InvariantCulture);
        YamlStream yaml = [];
        try
        {
            yaml.Load(new StringReader(body));
        }
        catch (YamlDotNet.Core.YamlException wrong)
        {
            throw new FormatException($"{path}: object &{fileId}: {wrong.Message}", wrong);
        }

        if (yaml.Documents.Count != 1 || yaml.Documents[0].RootNode is not YamlMappingNode { Children: { Count: 1 } children }
            || children[0].Key is not YamlScalarNode { Value: string type } || children[0].Value is not YamlMappingNode fields)
        {
            throw new FormatException($"{path}: object &{fileId}: must be one mapping named after its class");
        }

        return new UnityObject(classId, fileId, type, fields);
    }

    [GeneratedRegex(@"^--- !u!(\d+) &(\d+)\n", RegexOptions.Multiline)]
    private static partial Regex Head();
}

/// <summary>An object of a file.</summary>
/// <param name="ClassId">Unity's number of its class: 1 GameObject, 4 Transform, 114 MonoBehaviour.</param>
/// <param name="FileId">By which other objects of the file refer to it.</param>
/// <param name="TypeName">The name of its class, as written.</param>
/// <param name="Fields">Its fields in the order of the file.</param>
public sealed record UnityObject(int ClassId, long FileId, string TypeName, YamlMappingNode Fields)
{
    /// <summary>A field as it is written; null if there is none.</summary>
    public YamlNode? this[string field] => Fields.Children.TryGetValue(new YamlScalarNode(field), out YamlNode? found) ? found : null;
}
