using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RigidBodyDynamics.Web.Play;

/// <summary>
/// A scene file with the reader's changes: another integrator, and the keys as they were held. The command line computes from it the
/// motion that the page shows, to the bit.
/// </summary>
internal sealed class PlayedScene
{
    private static readonly string[] LabRules = [Rules.ExplicitEuler.Name, Rules.LabEuler.Name];
    private static readonly JsonDocumentOptions Lenient = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };
    private static readonly JsonWriterOptions Indented = new() { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly JsonObject _scene;

    /// <summary>A scene file that has been read without an error.</summary>
    /// <param name="text">Its text.</param>
    /// <param name="steps">Its steps.</param>
    /// <param name="rule">The integrator of all bodies that are not Unity's; null for those of the file.</param>
    public PlayedScene(string text, TimeSteps steps, string? rule)
    {
        _scene = JsonNode.Parse(text, documentOptions: Lenient)!.AsObject();
        Steps = steps;
        TakesKeys = _scene["bodies"] is JsonArray;
        if (rule != null && TakesKeys)
        {
            foreach (JsonObject body in Bodies(_scene).Where(body => !IsUnitys(body)))
                Move(body, rule);
        }

        HasEnd = steps.FirstOfOtherLength >= 0 || !TakesKeys || Bodies(_scene).Any(body => Effects(body).Any(effect => effect.ContainsKey("perStep")));
    }

    public TimeSteps Steps { get; }

    /// <summary>False for a recording, whose forces and torques are the recorded ones.</summary>
    public bool TakesKeys { get; }

    /// <summary>True where the file defines each step, and none after the last.</summary>
    public bool HasEnd { get; }

    /// <summary>The step from which the reader's keys replace the file's.</summary>
    public long? TakenOver { get; set; }

    /// <summary>The time at which the reader's keys begin, s.</summary>
    public double HandedOver => Steps.StartOf(TakenOver ?? 0);

    /// <summary>The keys that the reader has held.</summary>
    public Presses Presses { get; } = new();

    /// <summary>Names of the bodies on which the reader's keys act: those that have keys in the file, or all where none has.</summary>
    public IEnumerable<string> Pushed
    {
        get
        {
            bool someHave = Bodies(_scene).Any(HasKeys);
            return Bodies(_scene).Where(body => !someHave || HasKeys(body)).Select(body => (string)body["name"]!);
        }
    }

    /// <summary>The scene file without the reader's keys.</summary>
    public string Unpressed(long count) => Text(count, _ => []);

    /// <summary>The scene file.</summary>
    /// <param name="count">The number of steps.</param>
    public string Text(long count) => Text(count, body => [.. Presses.All.Select(Press), .. Idle(body)]);

    private string Text(long count, Func<JsonObject, IEnumerable<JsonObject>> presses)
    {
        JsonObject scene = _scene.DeepClone().AsObject();
        if (TakenOver != null)
        {
            HashSet<string> pushed = [.. Pushed];
            foreach (JsonObject body in Bodies(scene).Where(body => pushed.Contains((string)body["name"]!)))
                body["effects"] = new JsonArray([.. Without(Effects(body), HandedOver), .. presses(body)]);

            scene["about"] = $"as it was played, keys by hand from {HandedOver.ToString("0.##", CultureInfo.InvariantCulture)} s";
        }

        if (!HasEnd)
        {
            scene.Remove("duration");
            scene["steps"] = count;
        }

        using MemoryStream bytes = new();
        using (Utf8JsonWriter writer = new(bytes, Indented))
            scene.WriteTo(writer);

        return Encoding.UTF8.GetString(bytes.ToArray()) + "\n";
    }

    /// <summary>Effects without the keys of the file from a time on.</summary>
    private static IEnumerable<JsonObject> Without(IEnumerable<JsonObject> effects, double time)
    {
        foreach (JsonObject effect in effects)
        {
            JsonObject kept = effect.DeepClone().AsObject();
            if (IsKey(kept) && ((double?)kept["from"] ?? 0) >= time)
                continue;

            if (IsKey(kept))
                kept["to"] = Math.Min((double?)kept["to"] ?? time, time);

            yield return kept;
        }
    }

    private JsonObject Press((LabKey Key, long From, long To) press)
    {
        JsonObject effect = new() { ["key"] = press.Key.ToString(), ["from"] = Steps.StartOf(press.From) };
        if (press.To != Presses.Open)
            effect["to"] = Steps.StartOf(press.To);

        return effect;
    }

    /// <summary>
    /// A keyboard without held keys is a push of zero, under which an integrator of higher order takes steps, where without it the whole
    /// time would be one closed form, with other roundings. The file has the same push of zero in its place.
    /// </summary>
    private IEnumerable<JsonObject> Idle(JsonObject body) => Rules.Named((string?)body["integrator"] ?? Rules.Default.Name).Order > 1
        ? [new JsonObject { ["torque"] = new JsonObject { ["frame"] = "world", ["sin"] = new JsonArray(0, 0, 0) }, ["from"] = HandedOver }]
        : [];

    private static void Move(JsonObject body, string rule)
    {
        body["integrator"] = rule;
        if (!LabRules.Contains(rule))
            body.Remove("lab");
    }

    private static bool IsUnitys(JsonObject body) => (string?)body["integrator"] == Rules.UnityRigidbody.Name;

    private static bool IsKey(JsonObject effect) => effect.ContainsKey("key");

    private static bool HasKeys(JsonObject body) => Effects(body).Any(IsKey);

    private static IEnumerable<JsonObject> Bodies(JsonObject scene) => scene["bodies"]!.AsArray().Select(body => body!.AsObject());

    private static IEnumerable<JsonObject> Effects(JsonObject body) => body["effects"]?.AsArray().Select(effect => effect!.AsObject()) ?? [];
}
