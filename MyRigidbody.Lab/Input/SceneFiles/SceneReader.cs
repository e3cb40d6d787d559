using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>Reads a scene file ("rigid-body-scene/1") or a recording ("free-rigid-body/1", "lab-script/1").</summary>
internal static class SceneReader
{
    /// <summary>The schema of a scene.</summary>
    public const string Schema = "rigid-body-scene/1";

    /// <summary>Reads the file for a command that needs bodies one by one.</summary>
    public static SceneFile Read(string path)
    {
        SceneFile file = ReadWithCrowds(path);
        return file.Crowds.Count == 0
            ? file
            : throw new InputException($"{path}: bodies: only run and explain take a count, and \"{file.Crowds.Keys.First()}\" has one");
    }

    /// <summary>Reads the file; any error in it is an <see cref="InputException"/>.</summary>
    public static SceneFile ReadWithCrowds(string path) => JsonFile.Read(path, root =>
    {
        Fields fields = root.Fields();
        Place schema = fields.Required("schema");
        return schema.OneOf(Schema, Recording.Schema, Recording.ScriptSchema) switch
        {
            0 => Scene(fields),
            1 => RecordingReader.Read(root),
            _ => RecordingReader.ReadScript(root),
        };
    });

    private static SceneFile Scene(Fields fields)
    {
        string name = fields.Required("name").ShortText();
        string about = fields.Or("about", string.Empty, place => place.Text());
        fields.Or("$schema", string.Empty, place => place.Text());
        TimeSteps steps = Steps(fields);
        Place list = fields.Required("bodies");
        fields.End();

        Dictionary<string, MassProperties> solidBoxes = [];
        Dictionary<string, ManyBodies> crowds = [];
        Dictionary<string, IReadOnlyList<string>> notes = [];
        List<BodyDescription> bodies = [];
        HashSet<string> names = [];
        double bytes = 0;
        foreach (Place place in list.List("a list of bodies"))
        {
            BodyDescription body = BodyReader.Read(place, solidBoxes, crowds, notes);
            if (!names.Add(body.Name))
                throw place.Wrong($"name: must be unique in the scene, found \"{body.Name}\" again");

            place.Check(body, steps);
            bodies.Add(body);
            bytes += Memory.OfStretches(body, steps);
        }

        list.Make(() => Memory.MustHold("their effects", bytes));
        foreach (BodyDescription body in bodies)
        {
            if (NamedLike(body.Name, crowds) is string crowd)
                throw list.Wrong($"name: must be unique in the scene, found \"{body.Name}\" again among those of \"{crowd}\"");
        }

        if (bodies.Count == 0)
            throw list.Wrong("must have at least one body");

        return new SceneFile(list.File, new SceneDescription(name, about, steps, bodies), crowds, solidBoxes, null) { Meshes = fields.Meshes.Files, Notes = notes };
    }

    /// <summary>The crowd one of whose bodies has this name, "b 0"; null if there is none.</summary>
    private static string? NamedLike(string name, Dictionary<string, ManyBodies> crowds)
    {
        int space = name.LastIndexOf(' ');
        return space >= 0
            && crowds.TryGetValue(name[..space], out ManyBodies? crowd)
            && int.TryParse(name.AsSpan(space + 1), NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            && number < crowd.Count
            && name.Length - space - 1 == number.ToString(CultureInfo.InvariantCulture).Length
            && !crowds.ContainsKey(name)
                ? crowd.Body.Name
                : null;
    }

    private static TimeSteps Steps(Fields fields)
    {
        Place step = fields.Required("step");
        Place? duration = fields.Optional("duration"), count = fields.Optional("steps");
        if (step.Value.ValueKind == System.Text.Json.JsonValueKind.Array)
        {
            foreach (Place? extra in new[] { duration, count })
            {
                if (extra != null)
                    throw extra.Value.Wrong("must not stand beside a list of steps, which says it already");
            }

            double[] lengths = step.Numbers();
            return fields.Place.Make(() => TimeSteps.Of(lengths));
        }

        double length = step.Number();
        return (duration, count) switch
        {
            (Place d, null) => Make(d.Number(), seconds => TimeSteps.Until(seconds, length)),
            (null, Place n) => Make(n.Count(), number => TimeSteps.Every(length, number)),
            (null, null) => throw fields.Place.Wrong("\"duration\" or \"steps\" is missing"),
            _ => throw fields.Place.Wrong("\"duration\" and \"steps\" exclude each other"),
        };

        TimeSteps Make<T>(T value, Func<T, TimeSteps> make) => fields.Place.Make(() => make(value));
    }
}
