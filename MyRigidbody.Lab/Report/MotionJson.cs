using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Unicode;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>A motion for the scripts of the page: one column for each number of a body, rounded to the precision of a picture.</summary>
internal static class MotionJson
{
    // of position and orientation; and of velocities
    private const int Digits = 6, Fewer = 5;

    // no <, > or & either, so no name can end the script element around it
    private static readonly JsonWriterOptions Options = new() { Encoder = JavaScriptEncoder.Create(UnicodeRanges.All) };

    /// <summary>The motion, and the texts that scripts show.</summary>
    public static string Of(Motion motion)
    {
        using MemoryStream bytes = new();
        using (Utf8JsonWriter json = new(bytes, Options))
        {
            json.WriteStartObject();
            Column(json, "times", motion.At.Select(motion.Steps.StartOf), time => time.ToString("G9", CultureInfo.InvariantCulture));
            json.WriteStartArray("bodies");
            motion.Tracks.ForEach(track => Body(json, track));
            json.WriteEndArray();
            json.WriteStartArray("pairs");
            motion.Pairs.ForEach(pair => Pair(json, pair));
            json.WriteEndArray();
            json.WriteStartArray("held");
            foreach (Held held in motion.Held)
                Write(json, held);

            json.WriteEndArray();
            json.WriteStartObject("words");
            foreach ((string name, Word word) in Words.OfScripts)
                Write(json, name, word);

            json.WriteEndObject();
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(bytes.ToArray());
    }

    private static void Body(Utf8JsonWriter json, Track track)
    {
        List<BodyState> states = track.States;
        Quaterniond frame = track.Mass.PrincipalFrame.Normalized;
        json.WriteStartObject();
        json.WriteString("name", track.Name);
        if (track.Names is { } names)
            Write(json, "names", names);

        Rounded(json, "edges", Parts(track.Edges), Digits);
        Rounded(json, "boxFrame", Parts(track.Shape.PrincipalFrame.Normalized), Digits);
        Rounded(json, "center", Parts(track.Mass.CenterOfMass), Digits);
        Rounded(json, "moments", Parts(track.Mass.PrincipalMoments), Digits);
        Rounded(json, "frame", Parts(frame), Digits);
        Rounded(json, "position", states.SelectMany(state => Parts(state.Position)), Digits);
        Rounded(json, "orientation", states.SelectMany(state => Parts(state.Orientation)), Digits);
        Rounded(json, "spin", states.SelectMany(state => Parts(state.AngularVelocity)), Fewer);
        Rounded(json, "energy", states.Select(state => Conserved.KineticEnergy(state, track.Mass)), Fewer);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, Held held)
    {
        Word name = Words.Phrase(held.Name);
        json.WriteStartObject();
        json.WriteString("key", held.IsKey ? held.Name[4..] : null);
        json.WriteString("en", name.En);
        json.WriteString("zh", name.Zh);
        json.WriteNumber("from", held.From);
        json.WriteNumber("to", held.To);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, Word word)
    {
        json.WriteStartObject(name);
        json.WriteString("en", word.En);
        json.WriteString("zh", word.Zh);
        json.WriteEndObject();
    }

    private static void Pair(Utf8JsonWriter json, Distances pair)
    {
        json.WriteStartObject();
        json.WriteNumber("first", pair.First);
        json.WriteNumber("second", pair.Second);
        Rounded(json, "distance", pair.Distance, Fewer);
        Rounded(json, "angle", pair.Angle.Select(angle => angle * 180 / Math.PI), Fewer);
        if (pair.Spin is { } spin)
            Rounded(json, "spin", spin, Fewer);

        json.WriteEndObject();
    }

    /// <summary>Rounds to a number of digits of the largest value, and all values to the same decimal: a picture has one scale.</summary>
    private static void Rounded(Utf8JsonWriter json, string name, IEnumerable<double> values, int digits)
    {
        double[] column = [.. values];
        double largest = column.Max(Math.Abs);
        int decimals = largest > 0 ? digits - 1 - (int)Math.Floor(Math.Log10(largest)) : 0;
        Column(json, name, column, value => decimals is >= 0 and <= 15
            ? Shortest(Math.Round(value, decimals))
            : value.ToString("G" + digits, CultureInfo.InvariantCulture));
    }

    private static void Column(Utf8JsonWriter json, string name, IEnumerable<double> values, Func<double, string> text)
    {
        json.WriteStartArray(name);
        foreach (double value in values)
            json.WriteRawValue(text(value));

        json.WriteEndArray();
    }

    // no minus before a zero
    private static string Shortest(double value) => (value == 0 ? 0 : value).ToString("R", CultureInfo.InvariantCulture);

    private static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];

    private static double[] Parts(Quaterniond q) => [q.W, q.X, q.Y, q.Z];
}
