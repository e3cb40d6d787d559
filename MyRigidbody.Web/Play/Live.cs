using System.Runtime.InteropServices.JavaScript;
using System.Text;
using System.Text.Json;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Web.Play;

/// <summary>What the page asks of the simulation. What cannot be done is thrown, as one line for the reader.</summary>
internal static partial class Live
{
    private static readonly Rows Rows = new();
    private static Course? _course;

    private static Course Course => _course ?? throw new InvalidOperationException("no scene is open");

    /// <summary>The rules of the catalogue, one a line.</summary>
    [JSExport]
    internal static string RuleNames() => string.Join('\n', Rules.All.Select(rule => rule.Name));

    /// <summary>A file that lies beside scenes, which may name it.</summary>
    [JSExport]
    internal static void Put(string file, byte[] bytes) => File.WriteAllBytes(file, bytes);

    /// <summary>Opens a scene at its start. The scene that was open stays so if this one is refused.</summary>
    /// <param name="file">The name of its file.</param>
    /// <param name="text">What is in it.</param>
    /// <param name="rule">The rule of all bodies that are not Unity's; empty for those of the file.</param>
    /// <param name="besideUnity">Whether a body without one gets a body of Unity's beside it.</param>
    /// <param name="ownKeys">Whether the keys of the file are left out.</param>
    /// <param name="withScript">Whether a script's object stands beside the first body.</param>
    /// <returns>What the page needs to know to draw it, as JSON.</returns>
    [JSExport]
    internal static string Open(string file, string text, string rule, bool besideUnity, bool ownKeys, bool withScript) => Said(() =>
    {
        Course course = new(file, text, rule.Length > 0 ? rule : null, besideUnity, ownKeys);
        course.PutScript(withScript);
        Rows.Fit(course);
        _course = course;
        return Opened.Json(course, Rows);
    });

    /// <summary>Where rows lie in the memory of this program, and before them poses of the script.</summary>
    [JSExport]
    internal static int Address() => (int)Rows.Address;

    /// <summary>Steps by the keys that are held, and writes a row after each.</summary>
    /// <param name="held">A bit for each key, the first of <see cref="LabKey"/> the lowest.</param>
    /// <param name="count">How many steps, at most <see cref="Play.Rows.Most"/>.</param>
    /// <returns>How many rows there are: fewer where the scene ends.</returns>
    [JSExport]
    internal static int Step(int held, int count) => Said(() =>
    {
        int row = 0;
        for (; row < Math.Min(count, Play.Rows.Most) && Course.StepsDone < Course.Count; row++)
        {
            double before = Course.Time;
            Course.Step(held);
            if (Course.Script is { } script)
            {
                (Vector3d position, Quaterniond orientation) = Rows.Pose(row);
                script.Move(position, orientation, Course.Time - before);
            }

            Rows.Write(Course, row);
        }

        return row;
    });

    /// <summary>The scene file of what has been played.</summary>
    [JSExport]
    internal static string Played() => Said(() => Course.Played);

    /// <summary>The scene file as it was given, with the rule that was chosen.</summary>
    [JSExport]
    internal static string Chosen() => Said(() => Course.Chosen);

    /// <summary>What has been played as recordings: a list of files, name and text, as JSON.</summary>
    /// <param name="name">What they are called.</param>
    /// <param name="poses">Of the script's object after every step, seven numbers each.</param>
    [JSExport]
    internal static string Recordings(string name, double[] poses) => Said(() =>
    {
        using MemoryStream bytes = new();
        using (Utf8JsonWriter json = new(bytes))
        {
            json.WriteStartArray();
            foreach ((string file, string text) in RecordingFiles.Of(Course, name, poses))
            {
                json.WriteStartObject();
                json.WriteString("name", file);
                json.WriteString("text", text);
                json.WriteEndObject();
            }

            json.WriteEndArray();
        }

        return Encoding.UTF8.GetString(bytes.ToArray());
    });

    // the page shows the message of any error
    private static T Said<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (Exception refused) when (refused is InputException or ArgumentException or StateOverflowException or BrokenEffectException)
        {
            throw new InvalidOperationException(refused.Message.ReplaceLineEndings(" "));
        }
    }
}
