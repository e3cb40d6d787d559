using System.Text.Json.Nodes;
using CsCheck;
using NJsonSchema;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>The JSON Schema and the reader say the same.</summary>
public sealed class SchemaTests
{
    // a schema tests one value at a time, and cannot express these
    private static readonly string[] OnlyTheReaderKnows =
    [
        "unique", "sum of the other two", "must be later than from", "is for ", "the locked ", "scaled to it",
        "found 0", "as many as there are points", "must be the sum", "must not stand beside", "must not take more",
        "above zero, found (", "Infinity", "there is no such file", "none of them zero", "must enclose a volume", "a mesh in STL or OBJ", "at most 1e18", "finite kinetic energy",
        "pivot", "line", "which no body has",
    ];

    private static readonly string Written = File.ReadAllText(Root.File("scenes/rigid-body-scene-1.schema.json")), Renewed = SceneSchema.Renewed(Written);
    private static readonly JsonSchema Schema = JsonSchema.FromJsonAsync(Renewed).Result;

    private static readonly JsonNode?[] Values =
    [
        null, 0, -1, 1, 2.5, 1e300, true, "x", "LabEuler", "body", "R", new JsonArray(), new JsonObject(),
        new JsonArray(1, 2, 3), new JsonArray(1, 2, 3, 4), new JsonArray(1, "x", 3), new JsonArray(new JsonArray(1, 2, 3)), new JsonArray(0.1, 0.2),
    ];

    private static IEnumerable<string> Scenes =>
        Directory.GetFiles(Gallery.Folder, "*.json").Where(path => !path.EndsWith(".schema.json", StringComparison.Ordinal));

    [TestCaseSource(nameof(Scenes))]
    public void Scenes_of_the_gallery_are_valid_and_can_be_read(string path)
    {
        SceneFile file = SceneReader.Read(path);

        Assert.That(Schema.Validate(SceneText.Tree(File.ReadAllText(path)).ToJsonString()), Is.Empty);
        Assert.That(file.Scene.Name, Is.EqualTo(Path.GetFileNameWithoutExtension(path)));
        Assert.That(file.Scene.About, Is.Not.Empty);
    }

    [Test]
    public void The_scene_with_every_name_is_valid()
    {
        Assert.That(Schema.Validate(SceneText.Everything), Is.Empty);
    }

    [Test]
    public void Schema_in_scenes_has_the_effects_and_kinds_of_the_reader_s_tables_and_the_integrators_of_the_library()
    {
        if (Written != Renewed)
            File.WriteAllText(Root.File("scenes/rigid-body-scene-1.schema.json"), Renewed);

        Assert.That(Written, Is.EqualTo(Renewed), "it has been written anew: look at it, and test again");
    }

    [Test]
    public void Every_name_of_the_schema_stands_in_the_scene_with_every_name()
    {
        HashSet<string> inSchema = [], inScene = [];
        Collect(JsonNode.Parse(Renewed)!, inSchema, onlyProperties: true);
        Collect(SceneText.Tree(), inScene, onlyProperties: false);
        // the other way to say how long a scene is
        inScene.Add("steps");

        Assert.That(inSchema, Is.EquivalentTo(inScene));
    }

    [TestCase("""{ "from": 1 }""")]
    [TestCase("""{ "key": "R", "gravity": [0, 1, 0] }""")]
    [TestCase("""{ "impulse": { "time": 1 }, "to": 2 }""")]
    [TestCase("""{ "perStep": {}, "from": 2 }""")]
    public void An_effect_is_alone_and_has_a_window_only_where_it_can_by_both(string effect)
    {
        JsonNode scene = SceneText.Tree();
        scene["bodies"]![0]!["effects"]![0]!.ReplaceWith(JsonNode.Parse(effect));

        Assert.That(SceneText.Error(scene.ToJsonString()), Is.Not.Empty);
        Assert.That(Schema.Validate(scene.ToJsonString()), Is.Not.Empty);
    }

    [Test]
    public void Any_name_added_anywhere_is_refused_by_both()
    {
        foreach (string path in Objects(SceneText.Tree()))
        {
            JsonNode scene = SceneText.Tree();
            At(scene, path)["neu"] = 1;
            Assert.That(SceneText.Error(scene.ToJsonString()), Is.Not.Empty, path);
            Assert.That(Schema.Validate(scene.ToJsonString()), Is.Not.Empty, path);
        }
    }

    [Test]
    public void Any_value_put_anywhere_is_judged_alike_by_both()
    {
        int accepted = 0, refused = 0;
        foreach ((string path, JsonNode? value) in Search.In(Leaves(SceneText.Tree()).SelectMany(path => Values.Select(value => (path, value))), 10))
        {
            JsonNode scene = SceneText.Tree();
            At(scene, path).ReplaceWith(value?.DeepClone());
            string text = scene.ToJsonString(), error = SceneText.Error(text);
            bool isValid = Schema.Validate(text).Count == 0;
            if (!OnlyTheReaderKnows.Any(error.Contains))
                Assert.That(error.Length == 0, Is.EqualTo(isValid), $"{path} = {value?.ToJsonString() ?? "null"}: {error}");

            accepted += error.Length == 0 ? 1 : 0;
            refused += error.Length > 0 ? 1 : 0;
        }

        // both sides of the border were visited; measured 500 and 2398 of all
        TestContext.Out.WriteLine($"{accepted} accepted, {refused} refused");
        Assert.That(accepted, Is.GreaterThan(Search.Count(100, 20)));
        Assert.That(refused, Is.GreaterThan(Search.Count(500, 100)));
    }

    [Test]
    public void Whatever_is_done_to_a_scene_the_reader_answers_in_one_line()
    {
        string text = SceneText.Everything;
        Gen.Select(Gen.Int[0, text.Length - 1], Gen.Int[0, 40], Gen.String[Gen.Char["{}[]\",:0123456789.eE-+ntu\\\u0000刚"], 0, 4])
            .Sample(
                edit =>
                {
                    (int at, int length, string insert) = edit;
                    string broken = text[..at] + insert + text[Math.Min(text.Length, at + length)..];
                    string error = SceneText.Error(broken);
                    return !error.Contains('\n') && (error.Length == 0 || error.StartsWith("scene.json", StringComparison.Ordinal));
                },
                iter: 2000);
    }

    private static void Collect(JsonNode? node, HashSet<string> names, bool onlyProperties)
    {
        if (node is JsonArray array)
        {
            foreach (JsonNode? item in array)
                Collect(item, names, onlyProperties);
        }
        else if (node is JsonObject fields)
        {
            foreach ((string name, JsonNode? value) in fields)
            {
                bool holdsNames = onlyProperties && name == "properties";
                if (!onlyProperties)
                    names.Add(name);
                else if (holdsNames)
                    names.UnionWith(value!.AsObject().Select(field => field.Key));

                if (holdsNames)
                {
                    foreach ((string _, JsonNode? inner) in value!.AsObject())
                        Collect(inner, names, onlyProperties);
                }
                else
                {
                    Collect(value, names, onlyProperties);
                }
            }
        }
    }

    private static JsonNode At(JsonNode root, string path) =>
        path.Split('/', StringSplitOptions.RemoveEmptyEntries).Aggregate(root, (node, name) =>
            node is JsonArray array ? array[int.Parse(name)]! : node[name]!);

    private static IEnumerable<string> Objects(JsonNode node, string path = "") => node switch
    {
        JsonObject fields => fields.SelectMany(field => Objects(field.Value!, $"{path}/{field.Key}")).Prepend(path),
        JsonArray array => array.SelectMany((item, i) => Objects(item!, $"{path}/{i}")),
        _ => [],
    };

    private static IEnumerable<string> Leaves(JsonNode node, string path = "") => node switch
    {
        JsonObject fields => fields.SelectMany(field => Leaves(field.Value!, $"{path}/{field.Key}").Prepend($"{path}/{field.Key}")).Distinct(),
        JsonArray array => array.SelectMany((item, i) => Leaves(item!, $"{path}/{i}")),
        _ => [path],
    };
}
