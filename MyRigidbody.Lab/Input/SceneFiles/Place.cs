using System.Globalization;
using System.Text.Json;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>A value in a JSON file, with its place.</summary>
/// <param name="File">The file, as typed.</param>
/// <param name="Above">The object that contains it; null for the whole file.</param>
/// <param name="Name">The name of its field; empty for the whole file.</param>
/// <param name="Value">The value.</param>
/// <param name="Index">Its number in a list of that name.</param>
/// <param name="Inner">Its number in a list within that list.</param>
internal readonly record struct Place(string File, Fields? Above, string Name, JsonElement Value, int? Index = null, int? Inner = null)
{
    /// <summary>The largest number of characters of a name.</summary>
    public const int LongestName = 1000;

    private const int MostShown = 40;

    /// <summary>For instance <c>bodies[0].effects[2].from</c>; empty for the whole file.</summary>
    /// <remarks>Built only for an error, because a file may hold millions of places.</remarks>
    public string Path
    {
        get
        {
            string above = Above?.Place.Path ?? string.Empty, name = Shown(Name), path = above.Length > 0 ? $"{above}.{name}" : name;
            return path + Brackets(Index) + Brackets(Inner);
        }
    }

    /// <summary>The error at this place.</summary>
    public InputException Wrong(string what) => new(Path.Length > 0 ? $"{File}: {Path}: {what}" : $"{File}: {what}");

    /// <summary>The error that says what is expected here, and what was found.</summary>
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

    /// <summary>A text that is repeated: in every row of a table, in titles.</summary>
    public string ShortText() => Text() is string name && name.Length <= LongestName
        ? name
        : throw Wrong(string.Create(CultureInfo.InvariantCulture, $"must have at most {LongestName} characters, found {Text().Length}"));

    /// <summary>One of some words; returns its number.</summary>
    public int OneOf(params string[] words)
    {
        int at = Value.ValueKind == JsonValueKind.String ? Array.IndexOf(words, Value.GetString()) : -1;
        return at >= 0 ? at : throw Not("one of " + string.Join(", ", words.Select(word => $"\"{word}\"")));
    }

    /// <summary>The values of a list, one after another: a file may hold millions, and only a wrong one needs its place.</summary>
    public IEnumerable<Place> List(string of = "a list") =>
        Value.ValueKind == JsonValueKind.Array ? Items(this) : throw Not(of);

    /// <summary>Objects made from the values of a list.</summary>
    public T[] Items<T>(string of, Func<Place, T> read)
    {
        T[] items = new T[Value.ValueKind == JsonValueKind.Array ? Value.GetArrayLength() : throw Not(of)];
        int i = 0;
        foreach (JsonElement element in Value.EnumerateArray())
        {
            items[i] = read(Item(i, element));
            i++;
        }

        return items;
    }

    /// <summary>A list of finite numbers.</summary>
    public double[] Numbers(string of = "a list of numbers") => Items(of, item => item.Number());

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

    /// <summary>Finds errors in a body as a whole.</summary>
    public void Check(BodyDescription body, TimeSteps steps, IReadOnlyDictionary<string, string>? called = null) => Make(() =>
    {
        body.Check();
        // UnityRigidbody refuses what rounds to zero or infinity in single precision, and a mass may be used up; with all effects, and for all
        // integrators, a simulation would be much larger than the file
        return body.Rule == Rules.UnityRigidbody || body.Effects.Any(effect => effect.Motion is MassRate) ? new Simulation(steps, OfMass(body)) : null;
    }, called);

    /// <summary>The same body with only the effects that change its mass, each in its place among the effects.</summary>
    private static BodyDescription OfMass(BodyDescription body)
    {
        BodyDescription bare = body.Copy(body.Name, body.Mass).Without(_ => true);
        int last = body.Effects.ToList().FindLastIndex(effect => effect.Motion is MassRate);
        foreach (Effect effect in body.Effects.Take(last + 1))
            _ = effect.Motion is MassRate ? bare.With(effect) : bare.With(new LinearDamping(0));

        return bare;
    }

    /// <summary>Runs something with this value; an exception of the library becomes an error of this place.</summary>
    public void Make(Action attempt) => Make(() =>
    {
        attempt();
        return true;
    });

    /// <summary>Makes something from this value; an exception of the library becomes an error of this place.</summary>
    /// <param name="make">Makes it.</param>
    /// <param name="called">The names of fields that differ from the library's arguments.</param>
    public T Make<T>(Func<T> make, IReadOnlyDictionary<string, string>? called = null)
    {
        try
        {
            return make();
        }
        catch (ArgumentException refused)
        {
            // the library's message is "argument: requirement, found value"; the argument may be a field of this object, or one beside it
            string name = refused.ParamName ?? string.Empty;
            string rule = refused.Message.StartsWith(name + ": ", StringComparison.Ordinal) ? refused.Message[(name.Length + 2)..] : refused.Message;
            string argument = name.Split('[')[0], field = called?.GetValueOrDefault(argument) ?? argument;
            name = field + name[argument.Length..];
            Place? found = Has(this, field) ? new Place(File, Fields(), name, Value)
                : Above is Fields beside && Has(beside.Place, field) ? new Place(File, beside, name, Value) : null;
            throw (found ?? this).Wrong(rule);
        }
    }

    private static bool Has(Place place, string field) =>
        place.Value.ValueKind == JsonValueKind.Object && field.Length > 0 && place.Value.TryGetProperty(field, out _);

    private static IEnumerable<Place> Items(Place list)
    {
        int i = 0;
        foreach (JsonElement element in list.Value.EnumerateArray())
            yield return list.Item(i++, element);
    }

    private Place Item(int i, JsonElement element) =>
        Index == null ? this with { Value = element, Index = i } : this with { Value = element, Inner = i };

    private static string Brackets(int? index) =>
        index == null ? string.Empty : string.Create(CultureInfo.InvariantCulture, $"[{index}]");

    private string Found => Shown(Value.GetRawText());

    /// <summary>The value that was found, in one line of readable length.</summary>
    public static string Shown(string text)
    {
        string line = text.ReplaceLineEndings(" ");
        return line.Length <= MostShown ? line : line[..MostShown] + "…";
    }
}
