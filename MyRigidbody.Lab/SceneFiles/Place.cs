using System.Globalization;
using System.Text.Json;

namespace RigidBodyDynamics.Lab;

/// <summary>A value in a JSON file that knows where it stands.</summary>
/// <param name="File">The file, as the user called it.</param>
/// <param name="Path">For instance <c>bodies[0].effects[2].from</c>; empty for the whole file.</param>
/// <param name="Value">What stands there.</param>
internal readonly record struct Place(string File, string Path, JsonElement Value)
{
    private const int MostShown = 40;

    /// <summary>The error that says what is wrong here.</summary>
    public InputException Wrong(string what) => new(Path.Length > 0 ? $"{File}: {Path}: {what}" : $"{File}: {what}");

    /// <summary>The error that says what should stand here instead of what does.</summary>
    public InputException Not(string expected) => Wrong($"must be {expected}, found {Found}");

    /// <summary>A finite number.</summary>
    public double Number() =>
        Value.ValueKind != JsonValueKind.Number ? throw Not("a number")
        : Value.TryGetDouble(out double number) && double.IsFinite(number) ? number
        : throw Not("a number that fits double precision");

    /// <summary>A finite number in single precision, read as such.</summary>
    public float Single() =>
        Value.ValueKind != JsonValueKind.Number ? throw Not("a number")
        : Value.TryGetSingle(out float number) && float.IsFinite(number) ? number
        : throw Not("a number that fits single precision");

    /// <summary>A whole number from 1.</summary>
    public long Count() =>
        Value.ValueKind == JsonValueKind.Number && Value.TryGetInt64(out long count) && count >= 1
            ? count
            : throw Not("a whole number from 1");

    /// <summary>True or false.</summary>
    public bool Flag() =>
        Value.ValueKind is JsonValueKind.True or JsonValueKind.False ? Value.GetBoolean() : throw Not("true or false");

    /// <summary>A text.</summary>
    public string Text() => Value.ValueKind == JsonValueKind.String ? Value.GetString()! : throw Not("a text");

    /// <summary>One of some words; returns its number.</summary>
    public int OneOf(params string[] words)
    {
        int at = Value.ValueKind == JsonValueKind.String ? Array.IndexOf(words, Value.GetString()) : -1;
        return at >= 0 ? at : throw Not("one of " + string.Join(", ", words.Select(word => $"\"{word}\"")));
    }

    /// <summary>The values of a list, one after another: a file may hold millions, and only a wrong one needs its place.</summary>
    public IEnumerable<Place> List(string of = "a list") =>
        Value.ValueKind == JsonValueKind.Array ? Items(this) : throw Not(of);

    /// <summary>A list of finite numbers.</summary>
    public double[] Numbers(string of = "a list of numbers")
    {
        double[] numbers = new double[Value.ValueKind == JsonValueKind.Array ? Value.GetArrayLength() : throw Not(of)];
        int i = 0;
        foreach (JsonElement element in Value.EnumerateArray())
        {
            bool isNumber = element.ValueKind == JsonValueKind.Number && element.TryGetDouble(out numbers[i]) && double.IsFinite(numbers[i]);
            numbers[i] = isNumber ? numbers[i] : Item(i, element).Number();
            i++;
        }

        return numbers;
    }

    /// <summary>[x, y, z].</summary>
    public Vector3d Vector()
    {
        const string Shape = "three numbers [x, y, z]";
        double[] n = Numbers(Shape);
        return n.Length == 3 ? new Vector3d(n[0], n[1], n[2]) : throw Not(Shape);
    }

    /// <summary>[w, x, y, z], of any length but zero.</summary>
    public Quaterniond Turn()
    {
        const string Shape = "a quaternion [w, x, y, z]";
        double[] n = Numbers(Shape);
        Quaterniond turn = n.Length == 4 ? new Quaterniond(n[0], n[1], n[2], n[3]) : throw Not(Shape);
        return Make(() => Guard.Turn(turn, string.Empty));
    }

    /// <summary>The fields of an object.</summary>
    public Fields Fields() => new(this);

    /// <summary>Makes something of what stands here; what the library refuses is an error of this place.</summary>
    public T Make<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (ArgumentException refused)
        {
            // the library says "argument: rule, found value"; the argument may be a field of this object
            string name = refused.ParamName ?? string.Empty;
            string rule = refused.Message.StartsWith(name + ": ", StringComparison.Ordinal) ? refused.Message[(name.Length + 2)..] : refused.Message;
            string field = name.Split('[')[0];
            bool isField = Value.ValueKind == JsonValueKind.Object && field.Length > 0 && Value.TryGetProperty(field, out _);
            throw (isField ? this with { Path = Path.Length > 0 ? $"{Path}.{name}" : name } : this).Wrong(rule);
        }
    }

    private static IEnumerable<Place> Items(Place list)
    {
        int i = 0;
        foreach (JsonElement element in list.Value.EnumerateArray())
        {
            yield return list.Item(i++, element);
        }
    }

    private Place Item(int i, JsonElement element) =>
        new(File, string.Create(CultureInfo.InvariantCulture, $"{Path}[{i}]"), element);

    private string Found
    {
        get
        {
            string text = Value.GetRawText().ReplaceLineEndings(" ");
            return text.Length <= MostShown ? text : text[..MostShown] + "…";
        }
    }
}
