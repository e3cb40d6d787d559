using RigidBodyDynamics.Lab.Comparison;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The data of replay and plots: states of bodies at moments, differences of pairs, and the effects with their times.</summary>
internal sealed class Motion
{
    private const int MostHeld = 12;
    private const double ImpulseSeen = 0.05;

    private Motion(TimeSteps steps, int bodies)
    {
        Steps = steps;
        BodiesInScene = bodies;
    }

    /// <summary>The division of the run's time.</summary>
    public TimeSteps Steps { get; }

    /// <summary>The number of bodies, drawn or not.</summary>
    public int BodiesInScene { get; }

    /// <summary>The bodies that are drawn.</summary>
    public List<Track> Tracks { get; } = [];

    /// <summary>The pairs among them.</summary>
    public List<Distances> Pairs { get; } = [];

    /// <summary>The number of steps before each moment.</summary>
    public List<long> At { get; } = [];

    /// <summary>The effects that act for a part of the time.</summary>
    public IReadOnlyList<Held> Held { get; set; } = [];

    /// <summary>The pairs of a comparison.</summary>
    public static Motion Of(SceneFile file, IReadOnlyList<Findings> found)
    {
        Motion motion = new(file.Scene.Steps, 2 * found.Count);
        foreach (Findings pair in found.Take(Frames.MostBodies / 2))
        {
            motion.Add(
                new Track(pair.Pair.Mine.Name, pair.Pair.Mine.Mass, Shape(file, pair.Pair.Mine)),
                new Track(pair.Pair.Default.Name, pair.Pair.Default.Mass, Shape(file, pair.Pair.Default)),
                pair.Course);
        }

        motion.Thin(found[0].Course);
        motion.Held = HeldBy(found.SelectMany(pair => new[] { pair.Pair.Mine, pair.Pair.Default }), file.Scene.Steps);
        return motion;
    }

    /// <summary>Bodies followed elsewhere, with their states at the start and after every step.</summary>
    /// <param name="steps">The steps.</param>
    /// <param name="tracks">The bodies.</param>
    /// <param name="pairs">The compared pairs.</param>
    public static Motion Of(TimeSteps steps, IReadOnlyList<Track> tracks, IReadOnlyList<(int First, int Second)> pairs)
    {
        Motion motion = new(steps, tracks.Count);
        motion.Tracks.AddRange(tracks);
        motion.At.AddRange(Enumerable.Range(0, tracks[0].States.Count).Select(at => (long)at));
        motion.Pairs.AddRange(pairs.Select(pair => new Distances(
            pair.First,
            pair.Second,
            [.. tracks[pair.First].States.Zip(tracks[pair.Second].States, (a, b) => (a.Position - b.Position).Length)],
            [.. tracks[pair.First].States.Zip(tracks[pair.Second].States, (a, b) => Conserved.AngleBetween(a.Orientation, b.Orientation))])));
        return motion;
    }

    /// <summary>A recorded body and the simulated one; the moments are those after every step.</summary>
    public static Motion Of(SceneFile file, string recorded, IReadOnlyList<Compared> course, bool knowsSpin)
    {
        SceneDescription scene = file.Scene;
        Motion motion = new(scene.Steps, 2);
        BodyDescription body = scene.Bodies[0];
        MassProperties shape = Shape(file, body);
        motion.Add(new Track(body.Rule.Name, body.Mass, shape), new Track(recorded, body.Mass, shape), course);
        if (knowsSpin)
            motion.Pairs[0] = motion.Pairs[0] with { Spin = [.. motion.Tracks[0].States.Zip(motion.Tracks[1].States, (a, b) => (a.AngularVelocity - b.AngularVelocity).Length)] };

        motion.Thin(course);
        motion.Held = HeldBy([body], scene.Steps);
        return motion;
    }

    /// <summary>All bodies of a scene, run once more for the moments of a page.</summary>
    public static Motion Of(SceneFile file, SceneDescription scene, Simulation simulation)
    {
        Motion motion = new(scene.Steps, simulation.Bodies.Count);
        motion.Tracks.AddRange(simulation.Bodies.Take(Frames.MostBodies)
            .Select(body => new Track(ManyBodies.NameOf(body), body.Mass, Shape(file, body.Plan.Asked))));
        long end = scene.Steps.Count;
        foreach (long step in Frames.Of(end == long.MaxValue ? end : end + 1, motion.Tracks.Count))
        {
            simulation.Step(step - simulation.StepsDone);
            RunAway.MustBeFinite(simulation, file.Path);
            motion.At.Add(step);
            for (int i = 0; i < motion.Tracks.Count; i++)
                motion.Tracks[i].States.Add(simulation.Bodies[i].State);
        }

        motion.Held = HeldBy(scene.Bodies, scene.Steps);
        return motion;
    }

    private void Add(Track mine, Track other, IReadOnlyList<Compared> course)
    {
        long[] rows = [.. Frames.Of(course.Count, Math.Min(BodiesInScene, Frames.MostBodies))];
        mine.States.AddRange(rows.Select(row => course[(int)row].Mine));
        other.States.AddRange(rows.Select(row => course[(int)row].Default));
        Tracks.Add(mine);
        Tracks.Add(other);
        Pairs.Add(new Distances(
            Tracks.Count - 2,
            Tracks.Count - 1,
            [.. rows.Select(row => course[(int)row].Apart.Distance)],
            [.. rows.Select(row => course[(int)row].Apart.Angle)]));
    }

    private void Thin(IReadOnlyList<Compared> course) =>
        At.AddRange(Frames.Of(course.Count, Tracks.Count).Select(row => course[(int)row].Step));

    private static MassProperties Shape(SceneFile file, BodyDescription body) =>
        file.SolidBoxes.GetValueOrDefault(body.Name, body.Mass);

    /// <summary>Each once, keys first; an effect without a time is in the plan. An impulse has no duration, and is shown for a part of the run.</summary>
    public static IReadOnlyList<Held> HeldBy(IEnumerable<BodyDescription> bodies, TimeSteps steps)
    {
        double end = steps.StartOf(steps.Count);
        return [.. bodies.SelectMany(body => body.Effects)
            .Where(effect => effect.Motion is KeyPush || effect.From > 0 || effect.To < end)
            .Select(effect => new Held(
                effect.Motion.ToString()!, effect.Motion is KeyPush, Math.Max(0, effect.From), Math.Min(end, effect.To + (effect.Motion is Impulse ? ImpulseSeen * end : 0))))
            .Distinct()
            .OrderBy(held => !held.IsKey)
            .Take(MostHeld)];
    }
}
