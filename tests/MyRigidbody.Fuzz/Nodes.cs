using System.Text.Json;

namespace RigidBodyDynamics.Fuzz;

/// <summary>A value in the text of a JSON file: from where to where it stands, and where the name before it begins.</summary>
internal readonly record struct Node(int Name, int Start, int End, JsonTokenType Type);

/// <summary>The values in the text of a JSON file, so that text can be changed where it means something.</summary>
internal static class Nodes
{
    private static readonly JsonReaderOptions Options = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };

    /// <summary>All values, those inside others too; none if the text is no JSON any more.</summary>
    public static List<Node> Of(byte[] json)
    {
        List<Node> nodes = [];
        Stack<(int Name, int Start)> open = new();
        int name = -1;
        try
        {
            Utf8JsonReader reader = new(json, Options);
            while (reader.Read())
            {
                int start = (int)reader.TokenStartIndex, end = (int)reader.BytesConsumed;
                switch (reader.TokenType)
                {
                    case JsonTokenType.PropertyName:
                        name = start;
                        continue;
                    case JsonTokenType.StartArray or JsonTokenType.StartObject:
                        open.Push((name, start));
                        break;
                    case JsonTokenType.EndArray or JsonTokenType.EndObject:
                        (int before, int from) = open.Pop();
                        nodes.Add(new Node(before, from, end, reader.TokenType));
                        break;
                    default:
                        nodes.Add(new Node(name, start, end, reader.TokenType));
                        break;
                }

                name = -1;
            }

            return nodes;
        }
        catch (JsonException)
        {
            return [];
        }
    }
}
