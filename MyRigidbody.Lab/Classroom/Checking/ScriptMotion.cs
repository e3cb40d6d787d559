using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Report;
using Keys = RigidBodyDynamics.Judging.Keys;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>
/// The script beside the reference and Unity's body, on a cube and on a box, whose moments differ; all three of a kind with the
/// same recorded keys.
/// </summary>
internal static class ScriptMotion
{
    // as many frames of the cube's minute as there are of the box
    private const int MostFrames = 600;

    private const double KeyForce = 5;

    private static readonly (Keys Key, Vector3d Force)[] Arrows =
        [(Keys.LeftArrow, new(-KeyForce, 0, 0)), (Keys.RightArrow, new(KeyForce, 0, 0)), (Keys.UpArrow, new(0, KeyForce, 0)), (Keys.DownArrow, new(0, -KeyForce, 0))];

    public static Motion Of(Judging.Recording recording)
    {
        Run cube = recording.Runs[0], box = recording.Runs[1];
        int frames = Math.Min(MostFrames, Math.Min(cube.Frames.Count, box.Frames.Count));
        return Motion.Of(TimeSteps.Every(FrameInput.FixedDelta, frames), [.. Tracks(cube, frames, CheckWords.All["cube"]), .. Tracks(box, frames, CheckWords.All["box"])], [(0, 1), (0, 2), (3, 4), (3, 5)]);
    }

    private static IEnumerable<Track> Tracks(Run run, int frames, Word of)
    {
        Word Name(string key) => Word.Name("{0} · {1}").With(CheckWords.All[key], of);

        double mass = run.Frames[0].Before.Mass is > 0 and < double.PositiveInfinity and var known ? known : 1;
        Vector3d[] vertices = [.. run.Setting.Vertices.Select(v => new Vector3d(v.X * run.Setting.Scale.X, v.Y * run.Setting.Scale.Y, v.Z * run.Setting.Scale.Z))];
        Vector3d edges = 2 * new Vector3d(vertices.Max(v => v.X), vertices.Max(v => v.Y), vertices.Max(v => v.Z));
        MassProperties points = PointMasses.Equal(mass, vertices), solid = Solids.Box(mass, edges);
        Orientation turn = run.Setting.Pose.Orientation;
        // all three start with the same pose
        Quaterniond start = new Quaterniond(turn.W, turn.X, turn.Y, turn.Z).Normalized;

        BodyDescription reference = new BodyDescription(Name("reference").En, points) { Rule = Rules.LabEuler }.With(new DecayPerStep(0.98, 0.98));
        BodyDescription unity = new(Name("unity").En, solid) { Rule = Rules.UnityRigidbody };
        PerStep pushes = new([.. run.Frames.Take(frames).Select(Force)], [.. run.Frames.Take(frames).Select(Torque)]);
        BodyDescription[] others = [reference.With(pushes), unity.With(pushes)];
        foreach (BodyDescription other in others)
            other.Start = new BodyState(Vector3d.Zero, start, Vector3d.Zero, Vector3d.Zero);

        Track script = new(Name("script").En, points, solid) { Names = Name("script") };
        Vector from = run.Frames[0].Before.Position;
        script.States.Add(State(run.Frames[0].Before, from));
        script.States.AddRange(run.Frames.Take(frames).Select(frame => State(frame.After, from)));
        return [script, .. others.Zip(new[] { "reference", "unity" }, (other, key) => Played(other, Name(key), solid, frames))];
    }

    private static Track Played(BodyDescription body, Word names, MassProperties shape, int frames)
    {
        Simulation simulation = new(new SceneDescription(body.Name, string.Empty, TimeSteps.Every(FrameInput.FixedDelta, frames), [body]));
        Track track = new(body.Name, body.Mass, shape) { Names = names };
        track.States.Add(simulation.Bodies[0].State);
        for (int frame = 0; frame < frames; frame++)
        {
            simulation.Step();
            track.States.Add(simulation.Bodies[0].State);
        }

        return track;
    }

    private static Vector3d Force(Frame frame) =>
        Arrows.Where(arrow => frame.Input.Held.HasFlag(arrow.Key)).Aggregate(Vector3d.Zero, (sum, arrow) => sum + arrow.Force);

    // formula of the sheet: (sin t, sin t, sin t) at the frame's own time
    private static Vector3d Torque(Frame frame) =>
        frame.Input.Held.HasFlag(Keys.R) ? Math.Sin(frame.Input.Time) * new Vector3d(1, 1, 1) : Vector3d.Zero;

    private static BodyState State(Snapshot seen, Vector from) => new(
        Finite(new Vector3d(seen.Position.X - from.X, seen.Position.Y - from.Y, seen.Position.Z - from.Z)),
        new Quaterniond(seen.Orientation.W, seen.Orientation.X, seen.Orientation.Y, seen.Orientation.Z).Normalized,
        Finite(seen.Velocity is { } v ? new Vector3d(v.X, v.Y, v.Z) : Vector3d.Zero),
        Finite(seen.AngularVelocity is { } w ? new Vector3d(w.X, w.Y, w.Z) : Vector3d.Zero));

    // a wrong script may produce NaN or infinity
    private static Vector3d Finite(Vector3d v) => double.IsFinite(v.X + v.Y + v.Z) ? v : Vector3d.Zero;
}
