using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Fuzz;

/// <summary>
/// Files of some megabytes that repeat one structure each, so that the memory of a reader shows. Each is refused, most
/// at their very end: a program that reads them does nothing else.
/// </summary>
internal static class LargeFiles
{
    // just beyond a power of two, where tables that grow by doubling are largest
    private const int Size = 9_000_000;
    private const string Twice = ",{\"name\":\"b\"}]}";
    private const string Head = "{\"schema\":\"rigid-body-scene/1\",\"name\":\"n\",";
    private const string Body = Head + "\"step\":1,\"steps\":9,\"bodies\":[{\"name\":\"b\",";

    private static readonly Dictionary<string, Func<Input>> Kinds = new()
    {
        ["steps"] = () => Json(Head + "\"step\":[1", _ => ",1", "],\"bodies\":[{\"name\":\"b\"}" + Twice),
        ["points"] = () => Json(Body + "\"inertia\":{\"points\":[[1,0,0],[0,1,0]", _ => ",[0,0,1]", "]}}" + Twice),
        ["forces"] = () => Json(Body + "\"effects\":[{\"perStep\":{\"force\":[[0,0,0]", _ => ",[0,0,0]", "]}}]}" + Twice),
        ["bodies"] = () => Json(Body[..^1] + "}", i => $",{{\"name\":\"{i:x}_\"}}", Twice),
        ["bodies that move"] = () => Json(Body[..^1] + "}", i => $",{{\"name\":\"{i:x}_\",\"inertia\":{{\"principal\":[1,2,3]}},\"angularVelocity\":[1,0,0]}}", Twice),
        ["effects"] = () => Json(Body + "\"effects\":[{\"key\":\"R\"}", _ => ",{\"key\":\"R\"}", "]}" + Twice),
        ["a number too long"] = () => Json(Body + "\"mass\":1", _ => "0", "}]}"),
        ["a name too long"] = () => Json(Body + "\"", _ => "x", "\":1}]}"),
        ["names that nobody knows"] = () => Json(Body + "\"x\":1", i => $",\"{i:x}\":1", "}]}"),
        ["a text"] = () => Json(Head + "\"about\":\"", _ => "x", "\"}"),
        ["a text in place of a number"] = () => Json(Body + "\"mass\":\"", _ => "x", "\"}]}"),
        ["empty lists"] = () => Json(Body + "\"mass\":[[]", _ => ",[]", "]}" + Twice),
        ["brackets"] = () => Json("[", _ => "[", ""),
        ["zeros"] = () => new Input("zeros", new byte[Size], null),
        ["recorded"] = () => Recorded("0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"),
        ["a row without end"] = () => Recorded("0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,"),
    };

    /// <summary>Writes one file of every kind into a folder.</summary>
    public static void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        foreach ((string kind, Func<Input> make) in Kinds)
            make().Write(Path.Combine(folder, kind + ".json"));
    }

    private static Input Json(string head, Func<int, string> item, string tail)
    {
        StringBuilder text = new(head, Size + 100);
        for (int i = 0; text.Length < Size; i++)
            text.Append(item(i));

        return new Input("large", Encoding.UTF8.GetBytes(text.Append(tail).ToString()), null);
    }

    /// <summary>Half of it JSON, half of it rows, of which the last is missing.</summary>
    private static Input Recorded(string row)
    {
        Input recording = Input.Corpus().First(input => input.Name == "recording");
        string small = Encoding.UTF8.GetString(recording.Json);
        int steps = Size / (2 * (row.Length + 14));
        string numbers = string.Join(',', Enumerable.Repeat("0", 3 * steps));
        string json = small.Replace("\"steps\": 3", string.Create(CultureInfo.InvariantCulture, $"\"steps\": {steps}"), StringComparison.Ordinal)
            .Replace("[0.0199999996, 0.0199999996, 0.0199999996]", $"[{string.Join(',', Enumerable.Repeat("1", steps))}]", StringComparison.Ordinal)
            .Replace("[5, 0, 0, 5, 0, 0, 0, 0, 0]", $"[{numbers}]", StringComparison.Ordinal)
            .Replace("[0, 0, 0, 0.1, 0.2, 0.3, 0, 0, 0]", $"[{numbers}]", StringComparison.Ordinal);
        string header = Encoding.UTF8.GetString(recording.Csv!).Split('\n')[0];
        string csv = header + "\n" + string.Concat(Enumerable.Repeat(row, steps));
        return new Input("large", Encoding.UTF8.GetBytes(json), Encoding.UTF8.GetBytes(csv));
    }
}
