using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Whether a reference leads to something of the right kind.</summary>
internal sealed class References(UnityFile file, Project project)
{
    private const string Extra = "0000000000000000e000000000000000";

    // what comes with the engine has type 0
    private static readonly Dictionary<string, (string FileId, string Guid)> BuiltIn = new()
    {
        ["built-in cube"] = ("10202", Extra),
        ["built-in spot cookie"] = ("10001", Extra),
    };

    // the number of the main object in a file of a kind, and the type of a reference to one
    private static readonly Dictionary<string, (string FileId, string Type)> Main = new()
    {
        [".cs"] = ("11500000", "3"),
        [".mat"] = ("2100000", "2"),
        [".shader"] = ("4800000", "3"),
    };

    private readonly ILookup<long, UnityObject> _objects = file.Objects.ToLookup(o => o.FileId);

    /// <summary>What is wrong with a reference; null if nothing is.</summary>
    public string? Finding(YamlNode value, string kind)
    {
        string[] names = (value as YamlMappingNode)?.Children.Select(pair => pair.Key.Text()).ToArray() ?? [];
        bool isLocal = names.SequenceEqual(["fileID"]);
        if (!isLocal && !names.SequenceEqual(["fileID", "guid", "type"]))
            return "is not a reference";

        if (kind == "none")
            return isLocal && value.FileId() == 0 ? null : "should refer to nothing";

        if (kind.StartsWith("->", StringComparison.Ordinal))
            return isLocal ? Local(value.FileId(), kind) : "should refer to an object of this file";

        if (isLocal)
            return "should refer to another file";

        string fileId = value.Field("fileID").Text(), guid = value.Field("guid").Text(), type = value.Field("type").Text();
        return BuiltIn.TryGetValue(kind, out (string FileId, string Guid) builtIn)
            ? (fileId, guid, type) == (builtIn.FileId, builtIn.Guid, "0") ? null : $"should be {{fileID: {builtIn.FileId}, guid: {builtIn.Guid}, type: 0}}"
            : Asset(fileId, guid, type, kind["asset ".Length..]);
    }

    private string? Local(long fileId, string kind)
    {
        string wanted = kind[3..].Replace(" or none", string.Empty, StringComparison.Ordinal);
        if (fileId == 0)
            return kind.EndsWith(" or none", StringComparison.Ordinal) ? null : $"refers to nothing, not to a {wanted}";

        UnityObject? found = _objects[fileId].FirstOrDefault();
        if (found == null)
            return $"refers to &{fileId}, which is not in the file";

        bool fits = wanted == found.TypeName
            || wanted == "Component" && found["m_GameObject"] != null
            || found.TypeName == "MonoBehaviour" && found["m_Script"] is YamlMappingNode script && project.ScriptOf(script.Field("guid").Text())?.Name == wanted;
        return fits ? null : $"refers to the {found.TypeName} &{fileId}, not to a {wanted}";
    }

    private string? Asset(string fileId, string guid, string type, string ending)
    {
        string? path = project.Asset(guid);
        if (path == null)
            return $"refers to GUID {guid}, which no asset has";

        if (!path.EndsWith(ending, StringComparison.Ordinal))
            return $"refers to {path}, not to a {ending}";

        (string FileId, string Type) main = Main[ending];
        return (fileId, type) == main ? null : $"a reference to a {ending} has fileID {main.FileId} and type {main.Type}";
    }
}
