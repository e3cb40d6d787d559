using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>A scene of the bodies of a file, at rest, each in its own frame; impossible bodies are left out.</summary>
internal static class InertiaScene
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The scene, and the names of those that are left out.</summary>
    public static (string Json, IReadOnlyList<string> LeftOut) Of(InertiaFile file)
    {
        JsonArray bodies = [];
        List<string> leftOut = [];
        HashSet<string> names = [];
        foreach (DescribedBody body in file.Bodies)
        {
            if (Made(body) is not MassProperties mass)
            {
                leftOut.Add(body.Name);
                continue;
            }

            Quaterniond frame = mass.PrincipalFrame;
            JsonObject json = new()
            {
                ["name"] = Unique(body.Name, names),
                ["mass"] = mass.Mass,
                ["inertia"] = new JsonObject { ["principal"] = List(mass.PrincipalMoments), ["frame"] = new JsonArray(frame.W, frame.X, frame.Y, frame.Z) },
                ["centerOfMass"] = List(mass.CenterOfMass),
            };
            bodies.Add(json);
        }

        JsonObject scene = new()
        {
            ["schema"] = SceneReader.Schema,
            ["name"] = Short(Path.GetFileNameWithoutExtension(file.Path)),
            ["about"] = $"the bodies of {Path.GetFileName(file.Path)}, each in its own frame",
            ["step"] = 0.01,
            ["duration"] = 1,
            ["bodies"] = bodies,
        };
        return bodies.Count > 0
            ? (scene.ToJsonString(Indented) + "\n", leftOut)
            : throw new FellShortException($"{file.Path}: no body in it is one that a scene could have");
    }

    /// <summary>The mass properties, with the nearest possible tensor where the difference is one of the last digit; null if no body can have them.</summary>
    private static MassProperties? Made(DescribedBody body)
    {
        if (body.Mass is not double mass)
            return null;

        bool isRounded = Diagnosis.Of(body).Any(finding => finding.Code == "rounded");
        try
        {
            return MassProperties.FromTensor(mass, isRounded ? Nearest(body) : body.InBodyAxes, body.Center);
        }
        catch (ArgumentException)
        {
            return null;
        }
    }

    private static SymmetricMatrix3 Nearest(DescribedBody body)
    {
        SymmetricMatrix3 nearest = Tensors.Nearest(body.Tensor);
        return body.Axes == Quaterniond.Identity ? nearest : nearest.RotatedBy(Matrix3.Of(body.Axes.Normalized));
    }

    private static string Unique(string name, HashSet<string> names)
    {
        string unique = Short(name);
        for (int number = 2; !names.Add(unique); number++)
            unique = Short($"{name} ({number})");

        return unique;
    }

    private static string Short(string name) => name.Length <= 200 ? name : name[..100] + "…" + name[^99..];

    private static JsonArray List(Vector3d v) => new(v.X, v.Y, v.Z);
}
