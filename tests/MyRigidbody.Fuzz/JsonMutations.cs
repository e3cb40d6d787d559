using System.Globalization;
using System.Text;
using System.Text.Json;

namespace RigidBodyDynamics.Fuzz;

/// <summary>Changes a JSON text in its structure: values, names, whole objects.</summary>
internal sealed class JsonMutations
{
    private readonly string[] _names;
    private readonly Dictionary<JsonTokenType, byte[][]> _values;

    /// <summary>Mutations that also draw on all names and values of the seeds.</summary>
    public JsonMutations(IReadOnlyList<Input> seeds)
    {
        HashSet<string> names = [];
        HashSet<(JsonTokenType Type, string Text)> values = [];
        foreach (byte[] json in seeds.Select(seed => seed.Json))
        {
            foreach (Node node in Nodes.Of(json))
            {
                values.Add((node.Type, Encoding.UTF8.GetString(json[node.Start..node.End])));
                if (node.Name >= 0)
                    names.Add(Name(json, node));
            }
        }

        _names = [.. names];
        _values = values.Where(value => value.Text.Length < 400).GroupBy(value => value.Type)
            .ToDictionary(kind => kind.Key, kind => kind.Select(value => Text(value.Text)).ToArray());
    }

    /// <summary>One change; the text as it is if it is no JSON.</summary>
    public byte[] Change(byte[] json, Random random)
    {
        List<Node> nodes = Nodes.Of(json);
        if (nodes.Count == 0)
            return json;

        Node node = nodes[random.Next(nodes.Count)], other = nodes[random.Next(nodes.Count)];
        int first = node.Name >= 0 ? node.Name : node.Start;
        byte[] value = json[node.Start..node.End], whole = json[first..node.End];
        switch (random.Next(22))
        {
            case 0 or 1 or 2 or 3:
                return Put(json, node.Start, node.End, Text(OfItsKind(node, random)));
            case 4:
                return Put(json, node.Start, node.End, Text(Any(random)));
            case 5 or 6 or 7 or 8 or 9:
                // null is in no seed
                byte[][] alike = _values.GetValueOrDefault(node.Type, _values[JsonTokenType.Number]);
                return Put(json, node.Start, node.End, alike[random.Next(alike.Length)]);
            case 10 when node.Name >= 0:
                string name = random.Next(3) == 0 ? Hostile.Texts[random.Next(Hostile.Texts.Length)] : _names[random.Next(_names.Length)];
                return Put(json, node.Name, node.Start, Text(name + ": "));
            case 11:
                // beside another value, which may be the same name twice, a name in a list or a body twice
                return Put(json, other.Name >= 0 ? other.Name : other.Start, other.Name >= 0 ? other.Name : other.Start, [.. whole, (byte)',']);
            case 12 or 13:
                return Put(json, first, node.End, []);
            case 14 when node.End <= other.Start || other.End <= node.Start:
                (Node left, Node right) = node.Start < other.Start ? (node, other) : (other, node);
                return [.. json[..left.Start], .. json[right.Start..right.End], .. json[left.End..right.Start], .. json[left.Start..left.End], .. json[right.End..]];
            case 15:
                int depth = 1 << random.Next(8);
                return Put(json, node.Start, node.End, [.. Text(new string('[', depth)), .. value, .. Text(new string(']', depth))]);
            case 16:
                return Put(json, node.Start, node.End, [.. Text("{\"force\": "), .. value, .. Text("}")]);
            case 17:
                // a list that is much longer than any in use
                int times = 1 + random.Next(whole.Length < 100 ? 1000 : 20);
                byte[] more = [.. whole, (byte)','];
                return Put(json, first, first, [.. Enumerable.Repeat(more, times).SelectMany(bytes => bytes)]);
            case 20:
                return Windows(json, nodes, random);
            case 21:
                return Named(json, nodes, random);
            case 18:
                return Put(json, node.Start, node.Start, Text($"{_names[random.Next(_names.Length)]}: "));
            default:
                return Put(json, first, first, Text($"{_names[random.Next(_names.Length)]}: {Any(random)}, "));
        }
    }

    /// <summary>Puts up to a thousand effects, each with a window of its own, in the place of those of a body.</summary>
    private static byte[] Windows(byte[] json, List<Node> nodes, Random random)
    {
        Node[] effects = [.. nodes.Where(node => node.Type == JsonTokenType.StartArray && node.Name >= 0 && Name(json, node) == "\"effects\"")];
        if (effects.Length == 0)
            return json;

        Node list = effects[random.Next(effects.Length)];
        int count = 1 + random.Next(random.Next(2) == 0 ? 20 : 1002);
        IEnumerable<string> all = Enumerable.Range(0, count).Select(_ => string.Create(
            CultureInfo.InvariantCulture,
            $"{{\"{(random.Next(2) == 0 ? "force" : "gravity")}\":[1,0,0],\"from\":{random.NextDouble():0.###},\"to\":{(random.Next(4) == 0 ? "1e300" : (1 + random.NextDouble()).ToString("0.###", CultureInfo.InvariantCulture))}}}"));
        return Put(json, list.Start, list.End, Text("[" + string.Join(',', all) + "]"));
    }

    /// <summary>Gives the scene or the body an unusual name.</summary>
    private static byte[] Named(byte[] json, List<Node> nodes, Random random)
    {
        Node[] names = [.. nodes.Where(node => node.Type == JsonTokenType.String && node.Name >= 0 && Name(json, node) == "\"name\"")];
        if (names.Length == 0)
            return json;

        Node name = names[random.Next(names.Length)];
        return Put(json, name.Start, name.End, Text(Hostile.Texts[random.Next(Hostile.Texts.Length)]));
    }

    private static string Name(byte[] json, Node node)
    {
        Utf8JsonReader reader = new(json.AsSpan(node.Name));
        reader.Read();
        return Encoding.UTF8.GetString(json, node.Name, (int)reader.BytesConsumed);
    }

    private static string OfItsKind(Node node, Random random)
    {
        string[] kind = node.Type switch
        {
            JsonTokenType.Number => Hostile.Numbers,
            JsonTokenType.String => Hostile.Texts,
            _ => Hostile.Shapes,
        };
        return kind[random.Next(kind.Length)];
    }

    private static string Any(Random random)
    {
        string[] kind = random.Next(3) switch { 0 => Hostile.Numbers, 1 => Hostile.Texts, _ => Hostile.Shapes };
        return kind[random.Next(kind.Length)];
    }

    private static byte[] Text(string text) => Encoding.UTF8.GetBytes(text);

    private static byte[] Put(byte[] json, int from, int to, byte[] what) => [.. json[..from], .. what, .. json[to..]];
}
