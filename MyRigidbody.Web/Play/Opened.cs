using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Unicode;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Play;

/// <summary>The page's data about an opened scene: the motion, which has its first moment only, and its steps.</summary>
internal static class Opened
{
    private static readonly Word ScriptName = new("your script", "你的脚本");
    private static readonly JsonWriterOptions Options = new() { Encoder = JavaScriptEncoder.Create(UnicodeRanges.All) };

    public static string Json(Course course, Rows rows)
    {
        SceneDescription given = course.Given;
        using MemoryStream bytes = new();
        using (Utf8JsonWriter json = new(bytes, Options))
        {
            json.WriteStartObject();
            json.WritePropertyName("motion");
            json.WriteRawValue(MotionJson.Of(FirstMoment(course)));
            json.WriteString("name", given.Name);
            json.WriteString("about", given.About);
            json.WriteNumber("step", given.Steps.Length(0));
            json.WriteNumber("span", given.Steps.StartOf(given.Steps.Count));
            json.WriteNumber("count", course.Count);
            json.WriteNumber("most", Course.MostSteps);
            json.WriteNumber("mostRows", Rows.Most);
            json.WriteNumber("width", rows.Width);
            json.WriteBoolean("takesKeys", course.Scene.TakesKeys);
            json.WriteBoolean("ownKeys", course.Scene.TakenOver != null);
            Setting(json, course);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(bytes.ToArray());
    }

    private static Motion FirstMoment(Course course)
    {
        List<Track> tracks = [];
        foreach (Body body in course.Bodies)
            tracks.Add(At(new Track(body.Name, body.Mass, course.ShapeOf(body)), body.State));

        if (course.Script is { } script)
            tracks.Add(At(new Track(ScriptName.En, script.Mass, course.ShapeOf(course.Bodies[0])) { Names = ScriptName }, script.State));

        Motion motion = Motion.Of(course.Given.Steps, tracks, [.. Rows.PairsOf(course)]);
        motion.Held = Motion.HeldBy(course.Scene.TakenOver == null ? course.Given.Bodies : course.Bodies.Select(body => body.Plan.Asked), course.Given.Steps);
        return motion;
    }

    private static Track At(Track track, BodyState state)
    {
        track.States.Add(state);
        return track;
    }

    /// <summary>The object of a script: the first body's box, at the start of that body.</summary>
    private static void Setting(Utf8JsonWriter json, Course course)
    {
        BodyState start = course.Bodies[0].Plan.Asked.Start;
        json.WriteStartObject("setting");
        Numbers(json, "edges", course.Edges);
        Numbers(json, "position", start.Position);
        json.WriteStartArray("orientation");
        foreach (double part in new[] { start.Orientation.W, start.Orientation.X, start.Orientation.Y, start.Orientation.Z })
            json.WriteNumberValue(part);

        json.WriteEndArray();
        json.WriteNumber("fixedDelta", course.Given.Steps.Length(0));
        json.WriteEndObject();
    }

    private static void Numbers(Utf8JsonWriter json, string name, Vector3d v)
    {
        json.WriteStartArray(name);
        foreach (double part in new[] { v.X, v.Y, v.Z })
            json.WriteNumberValue(part);

        json.WriteEndArray();
    }
}
