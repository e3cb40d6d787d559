using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Play;

/// <summary>The motion so far as recordings, which <c>compare</c> reads: NAME.json has the input, NAME.csv the output.</summary>
internal static class RecordingFiles
{
    private const string Header = "step,t,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,wakeCounter,asleep";

    // the sheet's factor on the velocities, because that of the script is unknown
    private const double Decay = 0.98;

    // in steps: times of effects may miss the start of a step by a rounding
    private const double Same = 1e-6;

    private static readonly JsonWriterOptions Options = new() { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>For every body of Unity's that has only pushes and gravity, and for the script.</summary>
    /// <param name="course">The motion.</param>
    /// <param name="name">The name of the recordings.</param>
    /// <param name="poses">The poses of the script's object after every step, seven numbers each; empty without a script.</param>
    public static IEnumerable<(string Name, string Text)> Of(Course course, string name, ReadOnlySpan<double> poses)
    {
        List<(string, string)> files = [];
        SceneDescription scene = course.PlayedBodies();
        BodyDescription[] unitys = [.. scene.Bodies.Where(body => body.Rule == Rules.UnityRigidbody && body.Effects.All(IsRecorded))];
        foreach (BodyDescription body in unitys)
        {
            string called = unitys.Length == 1 ? name : $"{name}-{Array.IndexOf(unitys, body) + 1}";
            Simulation simulation = new(new SceneDescription(called, string.Empty, scene.Steps, [body]));
            List<(BodyState State, bool IsAsleep)> states = [(simulation.Bodies[0].State, simulation.Bodies[0].IsAsleep)];
            for (long step = 0; step < scene.Steps.Count; step++)
            {
                simulation.Step();
                states.Add((simulation.Bodies[0].State, simulation.Bodies[0].IsAsleep));
            }

            files.Add((called + ".json", Json(json => Head(json, called, body), scene.Steps, body, states)));
            files.Add((called + ".csv", Csv(scene.Steps, states)));
        }

        if (course.Script != null)
        {
            string called = name + "-script";
            BodyDescription first = scene.Bodies[0];
            List<(BodyState, bool)> states = Followed(scene.Steps, new ScriptBody(first.Mass, first.Start), poses);
            files.Add((called + ".json", Json(json => HeadOfScript(json, called, first, course), scene.Steps, first, states)));
            files.Add((called + ".csv", Csv(scene.Steps, states)));
        }

        return files;
    }

    private static bool IsRecorded(Effect effect) => effect.Motion is IPush || IsGravity(effect);

    private static bool IsGravity(Effect effect) => effect.Motion is Gravity && effect.From <= 0 && double.IsPositiveInfinity(effect.To);

    private static List<(BodyState, bool)> Followed(TimeSteps steps, ScriptBody script, ReadOnlySpan<double> poses)
    {
        List<(BodyState, bool)> states = [(script.State, false)];
        for (int step = 0; step < steps.Count && 7 * step + 7 <= poses.Length; step++)
        {
            ReadOnlySpan<double> n = poses.Slice(7 * step, 7);
            script.Move(new Vector3d(n[0], n[1], n[2]), new Quaterniond(n[3], n[4], n[5], n[6]), steps.Length(step));
            states.Add((script.State, false));
        }

        return states;
    }

    private static void Head(Utf8JsonWriter json, string name, BodyDescription body)
    {
        UnitySettings unity = body.Unity;
        Effect? gravity = body.Effects.FirstOrDefault(IsGravity);
        json.WriteString("schema", Recording.Schema);
        json.WriteString("name", name);
        json.WriteString("about", "played in the page");
        Number(json, "mass", body.Mass.Mass);
        Numbers(json, "inertiaTensor", Parts(body.Mass.PrincipalMoments));
        Numbers(json, "inertiaTensorRotation", Parts(body.Mass.PrincipalFrame.Normalized));
        Numbers(json, "centerOfMass", Parts(body.Mass.CenterOfMass));
        Number(json, "linearDamping", unity.Drag);
        Number(json, "angularDamping", unity.AngularDrag);
        Number(json, "maxAngularVelocity", unity.MaxAngularVelocity);
        Number(json, "sleepThreshold", unity.SleepThreshold);
        json.WriteBoolean("useGravity", gravity != null);
        json.WriteBoolean("gyroscopicForces", unity.GyroscopicForces);
        Numbers(json, "gravity", Parts(Acceleration(gravity)));
        Numbers(json, "position", Parts(body.Start.Position));
        Numbers(json, "rotation", Parts(body.Start.Orientation));
        Numbers(json, "linearVelocity", Parts(body.Start.Velocity));
        Numbers(json, "angularVelocity", Parts(body.Start.AngularVelocity));
        Number(json, "wakeCounter", unity.WakeCounter);
        if (body.Lock != Locks.None)
        {
            json.WriteStartObject("lock");
            json.WriteString("move", Axes(body.Lock, Locks.MoveX));
            json.WriteString("turn", Axes(body.Lock, Locks.TurnX));
            json.WriteEndObject();
        }
    }

    private static Vector3d Acceleration(Effect? gravity)
    {
        Coasting coasting = Coasting.Free;
        (gravity?.Motion as ICoast)?.AddTo(ref coasting, Solids.Sphere(1, 1));
        return coasting.Acceleration;
    }

    private static void HeadOfScript(Utf8JsonWriter json, string name, BodyDescription body, Course course)
    {
        json.WriteString("schema", Recording.ScriptSchema);
        json.WriteString("name", name);
        json.WriteString("about", "a script played in the page, a step a frame");
        Number(json, "mass", body.Mass.Mass);
        Numbers(json, "boxVertices", Parts(course.Edges));
        Number(json, "decayPerStep", Decay);
        Numbers(json, "position", Parts(body.Start.Position));
        Numbers(json, "rotation", Parts(body.Start.Orientation));
    }

    // the bits are x, y, z from the first on
    private static string Axes(Locks locked, Locks first) =>
        string.Concat("xyz".Where((_, i) => ((int)locked & ((int)first << i)) != 0));

    private static string Json(Action<Utf8JsonWriter> head, TimeSteps steps, BodyDescription body, List<(BodyState State, bool)> states)
    {
        using MemoryStream bytes = new();
        using (Utf8JsonWriter json = new(bytes, Options))
        {
            json.WriteStartObject();
            head(json);
            int count = states.Count - 1;
            Wrench[] pushes = [.. Enumerable.Range(0, count).Select(step => PushAt(steps, step, body, states[step].State))];
            json.WriteNumber("steps", count);
            Numbers(json, "dt", Enumerable.Range(0, count).Select(step => steps.Length(step)));
            Numbers(json, "force", pushes.SelectMany(push => Parts(push.Force)));
            Numbers(json, "torque", pushes.SelectMany((push, step) => Parts(push.TorqueInWorld(states[step].State.Orientation))));
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(bytes.ToArray()) + "\n";
    }

    /// <summary>The force and torque at the start of a step, world axes.</summary>
    private static Wrench PushAt(TimeSteps steps, long step, BodyDescription body, in BodyState state)
    {
        Wrench sum = default;
        double time = steps.StartOf(step), at = time + Same * steps.Length(step);
        foreach (Effect effect in body.Effects.Where(effect => effect.From <= at && at < effect.To))
            (effect.Motion as IPush)?.At(new Instant(step, time), state, body.Mass, ref sum);

        return sum;
    }

    private static string Csv(TimeSteps steps, List<(BodyState State, bool IsAsleep)> states)
    {
        StringBuilder rows = new(Header + "\n");
        for (int step = 0; step < states.Count; step++)
        {
            BodyState s = states[step].State;
            double[] numbers = [steps.StartOf(step), .. Parts(s.Position), .. Parts(s.Orientation), .. Parts(s.Velocity), .. Parts(s.AngularVelocity)];
            rows.Append(step).Append(',').AppendJoin(',', numbers.Select(Text)).Append(",0,").Append(states[step].IsAsleep ? "1\n" : "0\n");
        }

        return rows.ToString();
    }

    private static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];

    // here, unlike in scenes, the order is x, y, z, w
    private static double[] Parts(Quaterniond q) => [q.X, q.Y, q.Z, q.W];

    private static void Number(Utf8JsonWriter json, string name, double number)
    {
        json.WritePropertyName(name);
        json.WriteRawValue(Text(number));
    }

    private static void Numbers(Utf8JsonWriter json, string name, IEnumerable<double> numbers)
    {
        json.WritePropertyName(name);
        json.WriteRawValue("[" + string.Join(", ", numbers.Select(Text)) + "]");
    }

    // with nine digits every float is read back to the bit
    private static string Text(double number) => ((float)number).ToString("g9", CultureInfo.InvariantCulture);
}
