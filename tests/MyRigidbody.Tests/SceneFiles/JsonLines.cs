using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>A JSON Schema with a readable layout: the schema's own words follow each other, and every name that a file may have begins a line.</summary>
internal sealed class JsonLines
{
    private const int Width = 160;

    // the objects whose names are those of a file
    private static readonly string[] OfNames = ["properties", "definitions"];
    private static readonly JsonSerializerOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly StringBuilder _text = new();
    private int _lineStart;

    private int Left => Width - (_text.Length - _lineStart);

    public static string Of(JsonNode root)
    {
        JsonLines lines = new();
        lines.Write(root, string.Empty, areNames: false);
        return lines._text.Append('\n').ToString();
    }

    private void Write(JsonNode? node, string indent, bool areNames)
    {
        if (node is null or JsonValue || OneLine(node).Length < Left)
            _text.Append(OneLine(node));
        else if (node is JsonArray items)
            Write(items.Select(item => (string.Empty, item)), '[', ']', indent, areLines: true, areNames);
        else
            Write(node.AsObject().Select(field => (field.Key, field.Value)), '{', '}', indent, areNames, areNames);
    }

    private void Write(IEnumerable<(string Name, JsonNode? Value)> members, char begin, char end, string indent, bool areLines, bool areNames)
    {
        string separator = string.Empty;
        _text.Append(begin);
        foreach ((string name, JsonNode? value) in members)
        {
            string head = name.Length > 0 ? $"\"{name}\": " : string.Empty, whole = OneLine(value);
            _text.Append(separator);
            separator = ",";
            // what does not fit into any line may begin at the end of one
            bool stays = !areLines && head.Length + (whole.Length < Width - indent.Length && !OfNames.Contains(name) ? whole.Length : 1) + 2 < Left;
            if (stays)
                _text.Append(' ');
            else
                Break(indent + "  ");

            _text.Append(head);
            Write(value, areLines ? indent + "  " : indent, !areNames && OfNames.Contains(name));
        }

        if (areLines)
            Break(indent);
        else
            _text.Append(' ');

        _text.Append(end);
    }

    private void Break(string indent)
    {
        _text.Append('\n');
        _lineStart = _text.Length;
        _text.Append(indent);
    }

    private static string OneLine(JsonNode? node) => node switch
    {
        JsonObject fields => $"{{ {string.Join(", ", fields.Select(field => $"\"{field.Key}\": {OneLine(field.Value)}"))} }}",
        JsonArray items => $"[{string.Join(", ", items.Select(OneLine))}]",
        _ => node?.ToJsonString(Plain) ?? "null",
    };
}
