using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>The JSON Schema of a scene with what the library and the reader's table know put in: effects and integrators.</summary>
internal static class SceneSchema
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>A schema once more, with today's effects and integrators.</summary>
    public static string Renewed(string schema)
    {
        JsonNode root = JsonNode.Parse(schema)!, definitions = root["definitions"]!;
        definitions["effect"]!["oneOf"] = new JsonArray([.. EffectReader.Names.Select(Effect)]);
        definitions["body"]!["properties"]!["integrator"]!["enum"] = new JsonArray([.. Rules.All.Select(row => (JsonNode)row.Name)]);
        return root.ToJsonString(Indented) + "\n";
    }

    /// <summary>An effect with a value for every field it has.</summary>
    public static JsonObject Sample(string effect) => new() { [effect] = Described(effect).Sample!.DeepClone() };

    private static JsonNode Effect(string name)
    {
        JsonObject properties = new() { [name] = Described(name).Schema };
        if (EffectReader.HasWindow(name))
        {
            properties["from"] = About("Acts during the steps that start at from <= t, s; 0 if absent", "number");
            properties["to"] = About("and t < to, s; without end if absent", "number");
        }

        JsonObject schema = DescribedForm.ObjectOf("Effect " + name, properties);
        schema["required"] = new JsonArray(name);
        return schema;
    }

    private static DescribedForm Described(string effect)
    {
        DescribedForm form = new();
        EffectReader.Fill(effect, form);
        return form;
    }

    private static JsonObject About(string about, string type) => new() { ["description"] = about, ["type"] = type };
}

/// <summary>A form that keeps what it is asked for, and answers with numbers that every effect accepts.</summary>
internal sealed class DescribedForm : Form
{
    private readonly List<string> _required = [];
    private readonly List<(string Name, DescribedForm Form)> _fields = [];

    public JsonObject Schema { get; private set; } = new();

    public JsonNode? Sample { get; private set; }

    public static JsonObject ObjectOf(string about, JsonObject properties) =>
        new() { ["description"] = about, ["type"] = "object", ["additionalProperties"] = false, ["properties"] = properties };

    public override Form this[string field]
    {
        get
        {
            DescribedForm form = new();
            _required.Add(field);
            _fields.Add((field, form));
            return form;
        }
    }

    public override double Number(string about, double least, double most)
    {
        Is(about, 1);
        Schema["type"] = "number";
        if (double.IsFinite(least))
            Schema["minimum"] = least;

        if (double.IsFinite(most))
            Schema["maximum"] = most;

        return 1;
    }

    public override Vector3d Vector(string about)
    {
        Is(about, Ones);
        Schema["allOf"] = new JsonArray(ToVector);
        return new Vector3d(1, 1, 1);
    }

    public override Vector3d[] Vectors(string about)
    {
        Is(about, new JsonArray(Ones));
        Schema["type"] = "array";
        Schema["items"] = ToVector;
        return [new Vector3d(1, 1, 1)];
    }

    public override int OneOf(string about, params string[] words)
    {
        Is(about, words[0]);
        Schema["enum"] = new JsonArray([.. words.Select(word => (JsonNode)word)]);
        return 0;
    }

    public override T Object<T>(string about, Func<Form, T> read)
    {
        T made = read(this);
        Sample = new JsonObject(_fields.Select(field => KeyValuePair.Create(field.Name, field.Form.Sample)));
        Schema = ObjectOf(about, new JsonObject(_fields.Select(field => KeyValuePair.Create(field.Name, (JsonNode?)field.Form.Schema))));
        if (_required.Count > 0)
            Schema["required"] = new JsonArray([.. _required.Select(name => (JsonNode)name)]);

        return made;
    }

    public override T NumberOrObject<T>(string about, Func<Form, T> number, Func<Form, T> fields)
    {
        DescribedForm one = new(), many = new();
        number(one);
        T made = many.Object("One number for each", fields);
        Is(about, many.Sample!);
        Schema["oneOf"] = new JsonArray(one.Schema, many.Schema);
        return made;
    }

    public override T Or<T>(string field, T otherwise, Func<Form, T> read)
    {
        DescribedForm form = new();
        _fields.Add((field, form));
        return read(form);
    }

    private static JsonArray Ones => new(1, 1, 1);

    private static JsonObject ToVector => new() { ["$ref"] = "#/definitions/vector" };

    private void Is(string about, JsonNode sample)
    {
        Sample = sample;
        if (about.Length > 0)
            Schema["description"] = about;
    }
}
