using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Meshes;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>The JSON Schema of a scene with what the library and the reader's table know put in: effects, kinds of inertia and integrators.</summary>
internal static class SceneSchema
{
    /// <summary>A schema once more, with today's effects, kinds of inertia and integrators.</summary>
    public static string Renewed(string schema)
    {
        JsonNode root = JsonNode.Parse(schema)!, definitions = root["definitions"]!;
        JsonObject effect = DescribedForm.ObjectOf("Exactly one effect, and when it acts", new JsonObject([
            KeyValuePair.Create("from", About("Acts during the steps that start at from <= t, s; 0 if absent", "number")),
            KeyValuePair.Create("to", About("and t < to, s; without end if absent", "number")),
            .. EffectReader.Names.Select(name => KeyValuePair.Create(name, (JsonNode?)Effected(name).Schema))]));
        effect["oneOf"] = new JsonArray([.. EffectReader.Names.Select(Alone)]);
        definitions["effect"] = effect;
        definitions["inertia"]!["oneOf"] = new JsonArray([.. InertiaReader.Names.Select(kind => Described(form => InertiaReader.Fill(kind, form)).Schema)]);
        definitions["body"]!["properties"]!["integrator"]!["enum"] = new JsonArray([.. Rules.All.Select(row => (JsonNode)row.Name)]);
        return JsonLines.Of(root);
    }

    /// <summary>An effect with a value for every field it has.</summary>
    public static JsonObject Sample(string effect) => new() { [effect] = Effected(effect).Sample!.DeepClone() };

    /// <summary>A kind of inertia with a value for every field it has.</summary>
    public static JsonNode SampleInertia(string kind) => Described(form => InertiaReader.Fill(kind, form)).Sample!.DeepClone();

    private static JsonNode Alone(string name)
    {
        JsonObject alone = new() { ["required"] = new JsonArray(name) };
        if (!EffectReader.HasWindow(name))
            alone["not"] = new JsonObject { ["anyOf"] = new JsonArray(new JsonObject { ["required"] = new JsonArray("from") }, new JsonObject { ["required"] = new JsonArray("to") }) };

        return alone;
    }

    private static DescribedForm Effected(string effect) => Described(form => EffectReader.Fill(effect, form));

    private static DescribedForm Described(Action<Form> fill)
    {
        DescribedForm form = new();
        fill(form);
        return form;
    }

    private static JsonNode? About(string about, string type) => new JsonObject { ["description"] = about, ["type"] = type };
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

    // large beside the other numbers, as a tensor's diagonal is
    public override double Positive(string about)
    {
        Is(about, 5);
        Schema["type"] = "number";
        Schema["exclusiveMinimum"] = 0;
        return 5;
    }

    public override double[] Positives(string about)
    {
        Is(about, Of(Corners.Length, _ => 5));
        IsListOf(new DescribedForm().Positively(), 1);
        return [.. Corners.Select(_ => 5.0)];
    }

    public override Vector3d Lengths(string about)
    {
        Is(about, Ones);
        IsListOf(new DescribedForm().Positively(), 3);
        Schema["maxItems"] = 3;
        return new Vector3d(1, 1, 1);
    }

    public override Quaterniond Turn(string about)
    {
        Is(about, new JsonArray(1, 0, 0, 0));
        Schema["allOf"] = new JsonArray(Reference("quaternion"));
        return Quaterniond.Identity;
    }

    // no body is made of points on a line
    public override Vector3d[] Vectors(string about, int least)
    {
        Is(about, Of(Corners.Length, i => new JsonArray(Corners[i].X, Corners[i].Y, Corners[i].Z)));
        IsListOf(ToVector, least);
        return Corners;
    }

    public override T[] Parts<T>(string about, Func<Fields, T> read)
    {
        Is(about, JsonNode.Parse("""[{ "mass": 2, "inertia": { "solidSphere": 1 }, "position": [1, 0, 0], "orientation": [1, 0, 0, 1] }]""")!);
        IsListOf(Reference("part"), 1);
        using JsonDocument sample = JsonDocument.Parse(Sample!.ToJsonString());
        return [read(new Place("sample", null, string.Empty, sample.RootElement[0]).Fields())];
    }

    // the scene with every name has it beside it
    public override T Mesh<T>(string about, Func<MeshFile, T> read)
    {
        Is(about, SceneText.MeshName);
        Schema["type"] = "string";
        return read(new MeshFile(SceneText.MeshName, Surface.Box(new Vector3d(1, 1, 1)).Vertices, Surface.Box(new Vector3d(1, 1, 1)).Triangles, 0));
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

    public override T NumberOrObject<T>(string about, Func<Form, T> number, Func<Form, T> fields) =>
        Either(about, number, "One number for each", fields);

    public override T VectorOrObject<T>(string about, Func<Form, T> vector, Func<Form, T> fields) => Either(about, vector, string.Empty, fields);

    private T Either<T>(string about, Func<Form, T> shorthand, string aboutFields, Func<Form, T> fields)
    {
        DescribedForm one = new(), many = new();
        shorthand(one);
        T made = many.Object(aboutFields, fields);
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

    public override bool Has(string field) => true;

    private static JsonArray Ones => new(1, 1, 1);

    private static Vector3d[] Corners => [new(1, 1, 1), new(0, 1, 0), new(0, 0, 1)];

    private static JsonObject ToVector => Reference("vector");

    private static JsonObject Reference(string definition) => new() { ["$ref"] = "#/definitions/" + definition };

    private static JsonArray Of(int count, Func<int, JsonNode> item) => new([.. Enumerable.Range(0, count).Select(item)]);

    private JsonObject Positively()
    {
        Positive(string.Empty);
        return Schema;
    }

    private void IsListOf(JsonObject item, int least)
    {
        Schema["type"] = "array";
        Schema["items"] = item;
        if (least > 0)
            Schema["minItems"] = least;
    }

    private void Is(string about, JsonNode sample)
    {
        Sample = sample;
        if (about.Length > 0)
            Schema["description"] = about;
    }
}
