using System.Text;

namespace RigidBodyDynamics.Fuzz;

/// <summary>Makes an endless sequence of inputs from the seeds. Input number n is always the same.</summary>
internal sealed class Mutations(IReadOnlyList<Input> seeds, int seed)
{
    // unlimited growth would test the machine, not the reader
    private const int Largest = 1 << 18;

    private readonly JsonMutations _json = new(seeds);

    public Input Make(int number)
    {
        Random random = new(unchecked((seed * 1_000_003) + number));
        Input input = seeds[random.Next(seeds.Count)];
        byte[] json = input.Json;
        byte[]? csv = input.Csv;
        // what is damaged in many places is refused at the first: most are damaged in one
        for (int more = 0; more == 0 || (more < 5 && random.Next(3) == 0); more++)
        {
            // half of what is done to a recording is done to its rows
            if (csv != null && random.Next(2) == 0)
                csv = Lines(csv, random);
            else
                json = random.Next(8) == 0 ? Raw(json, random) : _json.Change(json, random);

            if (json.Length > Largest || csv?.Length > Largest)
                break;
        }

        return input with { Json = json, Csv = csv };
    }

    /// <summary>Changes bytes, whatever they mean.</summary>
    private static byte[] Raw(byte[] bytes, Random random)
    {
        int at = random.Next(bytes.Length + 1), end = Math.Min(bytes.Length, at + 1 + random.Next(16));
        switch (random.Next(7))
        {
            case 0:
                return Hostile.Encodings[random.Next(Hostile.Encodings.Length)](bytes);
            case 1:
                return bytes[..at];
            case 2:
                return [.. bytes[..at], .. bytes[end..]];
            case 3:
                return [.. bytes[..at], .. Hostile.Bytes[random.Next(Hostile.Bytes.Length)], .. bytes[at..]];
            case 4:
                return [.. bytes[..at], .. bytes[at..end], .. bytes[at..]];
            case 5 when at < bytes.Length:
                byte[] flipped = [.. bytes];
                flipped[at] ^= (byte)(1 << random.Next(8));
                return flipped;
            default:
                int from = random.Next(bytes.Length + 1);
                return [.. bytes[..at], .. bytes[from..Math.Min(bytes.Length, from + 100)], .. bytes[at..]];
        }
    }

    /// <summary>Changes rows and cells of a table.</summary>
    private static byte[] Lines(byte[] csv, Random random)
    {
        List<string> lines = [.. Encoding.UTF8.GetString(csv).Split('\n')];
        int at = random.Next(lines.Count);
        switch (random.Next(8))
        {
            case 0:
                lines.RemoveAt(at);
                break;
            case 1:
                lines.InsertRange(at, Enumerable.Repeat(lines[at], 1 + random.Next(50)));
                break;
            case 2:
                lines[at] = string.Concat(Enumerable.Repeat(lines[at] + ",", 1 + random.Next(200)));
                break;
            case 3:
                lines[at] = new string(",0\0\t;\""[random.Next(6)], 1 + random.Next(5000));
                break;
            case 4:
                return Raw(csv, random);
            case 5:
                return Encoding.UTF8.GetBytes(string.Join(random.Next(2) == 0 ? "\r\n" : "", lines));
            default:
                string[] cells = lines[at].Split(',');
                cells[random.Next(cells.Length)] = Hostile.Numbers[random.Next(Hostile.Numbers.Length)];
                lines[at] = string.Join(',', cells);
                break;
        }

        return Encoding.UTF8.GetBytes(string.Join('\n', lines));
    }
}
