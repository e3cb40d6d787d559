using System.Runtime.InteropServices.JavaScript;
using System.Text;
using System.Text.Json;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Web.Play;

/// <summary>The page's interface to the simulation. An error is thrown as one line for the reader.</summary>
internal static partial class Live
{
    private static readonly Rows Rows = new();
    private static Course? _course;

    private static Course Course => _course ?? throw new InvalidOperationException("no scene is open");

    /// <summary>The integrators of the catalogue, one a line.</summary>
    [JSExport]
    internal static string RuleNames() => string.Join('\n', Rules.All.Select(rule => rule.Name));

    /// <summary>Stores a file beside scenes, which may name it.</summary>
    [JSExport]
    internal static void Put(string file, byte[] bytes) => File.WriteAllBytes(file, bytes);

    /// <summary>Opens a scene at its start. If it is refused, the open scene stays.</summary>
    /// <param name="file">The name of its file.</param>
    /// <param name="text">Its text.</param>
    /// <param name="rule">The integrator of all bodies that are not Unity's; empty for those of the file.</param>
    /// <param name="besideUnity">True if a body without one gets a body of Unity's beside it.</param>
    /// <param name="ownKeys">True if the keys of the file are left out.</param>
    /// <param name="withScript">True if there is a script's object beside the first body.</param>
    /// <returns>The page's data for drawing it, as JSON.</returns>
    [JSExport]
    internal static string Open(string file, string text, string rule, bool besideUnity, bool ownKeys, bool withScript) => Said(() =>
    {
        Course course = new(file, text, rule.Length > 0 ? rule : null, besideUnity, ownKeys);
        course.PutScript(withScript);
        Rows.Fit(course);
        _course = course;
        return Opened.Json(course, Rows);
    });

    /// <summary>The address of the rows in the memory of this program, after poses of the script.</summary>
    [JSExport]
    internal static int Address() => (int)Rows.Address;

    /// <summary>Steps with the keys held, and writes a row after each step.</summary>
    /// <param name="held">A bit for each key, the first of <see cref="LabKey"/> the lowest.</param>
    /// <param name="count">The number of steps, at most <see cref="Play.Rows.Most"/>.</param>
    /// <returns>The number of rows: fewer where the scene ends.</returns>
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

    /// <summary>The scene file of the motion so far.</summary>
    [JSExport]
    internal static string Played() => Said(() => Course.Played);

    /// <summary>The scene file as given, with the chosen integrator.</summary>
    [JSExport]
    internal static string Chosen() => Said(() => Course.Chosen);

    /// <summary>The motion so far as recordings: a list of files, name and text, as JSON.</summary>
    /// <param name="name">Their name.</param>
    /// <param name="poses">The poses of the script's object after every step, seven numbers each.</param>
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

    // the page shows the message of any error, in its own language
    private static T Said<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (Exception refused) when (refused is InputException or ArgumentException or StateOverflowException or BrokenEffectException)
        {
            throw new InvalidOperationException(Refused.InBoth(refused.Message));
        }
    }
}
