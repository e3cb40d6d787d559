using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>Scenes as text, and what the reader says of them.</summary>
internal static class SceneText
{
    /// <summary>A mesh that stands beside every scene: a cube.</summary>
    public const string MeshName = "零件 part.obj";

    private const string Written = """
        {
          "$schema": "rigid-body-scene-1.schema.json", "schema": "rigid-body-scene/1",
          "name": "all", "about": "every name", "step": 0.01, "duration": 0.5,
          "bodies": [
            { "name": "a", "integrator": "LabEuler", "mass": 2, "inertia": { "boxVertices": [1, 2, 3] }, "centerOfMass": [0.1, 0, 0],
              "position": [1, 2, 3], "orientation": [1, 0, 0, 1], "velocity": [1, 0, 0], "angularVelocity": [0, 1, 0],
              "canMove": true, "canTurn": true, "lab": { "normalise": true, "firstOrderOrientation": true, "unitRotation": true },
              "effects": [
                { "gravity": [0, -9.81, 0], "from": 0, "to": 0.25 }, { "force": [1, 0, 0] }, { "key": "UpArrow", "from": 0.1 },
                { "torque": { "frame": "body", "constant": [1, 0, 0], "sin": [0, 1, 0], "cos": [0, 0, 1], "rate": 2 } },
                { "linearDamping": 0.1 }, { "angularDamping": 0.2 }, { "quadraticDrag": 0.3 }, { "decayPerStep": 0.98 },
                { "decayPerStep": { "linear": 0.99, "angular": 0.98 } },
                { "force": { "frame": "body", "constant": [0, 2, 0], "sin": [1, 0, 0], "cos": [0, 0, 1], "rate": 3, "at": [0.5, 0, 0] } },
                { "spring": { "anchor": [0, 1, 0], "at": [0, 2, 0], "stiffness": 3 } },
                { "perStep": { "force": [[1, 0, 0]], "torque": [[0, 1, 0], [0, 0, 1]] } }OTHERS
              ] },
            { "name": "b", "integrator": "UnityRigidbody", "inertia": { "principal": [1, 2, 3], "frame": [1, 1, 0, 0] }, "angularVelocityBody": [1, 2, 3],
              "unity": { "drag": 0.1, "angularDrag": 0.2, "maxAngularVelocity": 9, "sleepThreshold": 0.01, "wakeCounter": 0.2,
                         "gyroscopicForces": true, "firstOrderOrientation": true, "precision": "double" } },
            { "name": "c", "inertia": { "solidSphere": 0.5 }, "count": 3, "seed": 7,
              "spread": { "position": [1, 2, 3], "orientation": 0.5, "velocity": [1, 1, 1], "angularVelocity": [1, 2, 1] } },
            { "name": "d", "inertia": { "solidBox": [1, 1, 2] }, "lock": { "move": "xz", "turn": "y" } },
            { "name": "e", "inertia": { "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "masses": [1, 2, 3, 4] } },
            { "name": "f", "about": "origin", "centerOfMass": [0, 0, 0.5], "inertia": { "tensor": { "xx": 3, "yy": 4, "zz": 5, "xy": 0.1, "xz": 0.2, "yz": 0.3 } } },
            { "name": "g", "inertia": { "solidSphere": 0.5 }, "centerOfMass": [0.2, 0, 0],
              "effects": [ { "heavyTop": { "axis": [1, 0, 0], "moment": 3, "up": [0, 1, 0], "inertiaAbout": "centerOfMass" } } ] }KINDS
          ]
        }
        """;

    /// <summary>A scene with every name of the format in it; an effect or a kind of inertia that is not written above stands in it with a value for every field.</summary>
    public static string Everything { get; } = Written
        .Replace("OTHERS", string.Concat(Others(EffectReader.Names).Select(name => ", " + SceneSchema.Sample(name).ToJsonString())), StringComparison.Ordinal)
        .Replace("KINDS", string.Concat(Others(InertiaReader.Names).Select(BodyOf)), StringComparison.Ordinal);

    private static IEnumerable<string> Others(IEnumerable<string> names) => names.Where(name => !Written.Contains($"\"{name}\""));

    private static string BodyOf(string kind) => $$""", { "name": "{{kind}}", "inertia": {{SceneSchema.SampleInertia(kind).ToJsonString()}} }""";

    /// <summary>The scene as a tree that can be changed.</summary>
    public static JsonNode Tree(string? text = null) =>
        JsonNode.Parse(text ?? Everything, null, new JsonDocumentOptions { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip })!;

    /// <summary>Reads a text as the file "scene.json" of some folder.</summary>
    public static SceneFile Read(string text)
    {
        using TemporaryFolder folder = new();
        string path = folder.File("scene.json");
        File.WriteAllText(path, text);
        File.WriteAllText(folder.File(MeshName), MeshText.Obj(Surface.Box(new Vector3d(1, 1, 1))));
        return SceneReader.ReadWithCrowds(path);
    }

    /// <summary>What the reader says of a text, without the folder; empty if it accepts it.</summary>
    public static string Error(string text)
    {
        try
        {
            Read(text);
            return string.Empty;
        }
        catch (InputException refused)
        {
            return refused.Message[refused.Message.IndexOf("scene.json", StringComparison.Ordinal)..];
        }
    }
}
