using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Play;

/// <summary>A played scene: its bodies, Unity's beside those that have none in the file, and the script's.</summary>
internal sealed class Course
{
    /// <summary>The number of steps that are kept: 20 minutes of the lab's.</summary>
    public const long MostSteps = 60_000;

    private readonly string _path;
    private readonly bool _besideUnity;
    private bool _isPlain;
    private SceneFile _file = null!;
    private Simulation _simulation = null!;

    /// <summary>A scene at its start.</summary>
    /// <param name="path">Its file, beside the meshes that it names.</param>
    /// <param name="text">Its text.</param>
    /// <param name="rule">The integrator of all bodies that are not Unity's; null for those of the file.</param>
    /// <param name="besideUnity">True if a body without a body of Unity's beside it gets one, as in <c>compare</c>.</param>
    /// <param name="ownKeys">True if the keys of the file are left out.</param>
    /// <exception cref="InputException">The error in the file, in one line.</exception>
    public Course(string path, string text, string? rule, bool besideUnity, bool ownKeys)
    {
        _path = path;
        _besideUnity = besideUnity;
        File.WriteAllText(path, text);
        SceneFile given = SceneReader.Read(path);
        Given = given.Scene;
        Scene = new PlayedScene(text, given.Scene.Steps, rule);
        if (ownKeys && Scene.TakesKeys)
            Scene.TakenOver = 0;

        Begin();
    }

    /// <summary>The scene of the file.</summary>
    public SceneDescription Given { get; }

    public PlayedScene Scene { get; }

    /// <summary>The bodies, without the script's.</summary>
    public IReadOnlyList<Body> Bodies => _simulation.Bodies;

    /// <summary>The compared pairs.</summary>
    public IReadOnlyList<(int First, int Second)> Pairs { get; private set; } = [];

    /// <summary>The script's object.</summary>
    public ScriptBody? Script { get; private set; }

    public long StepsDone => _simulation.StepsDone;

    /// <summary>Time since the start, s.</summary>
    public double Time => _simulation.Time;

    /// <summary>The largest number of steps.</summary>
    public long Count => _simulation.Scene.Steps.Count;

    /// <summary>The scene file of the motion so far.</summary>
    public string Played => Scene.Text(Math.Max(1, StepsDone));

    /// <summary>The scene file as given, with the chosen integrator.</summary>
    public string Chosen => Scene.Unpressed(Given.Steps.Count);

    /// <summary>The motion so far, read from its scene file, with the bodies of Unity's.</summary>
    public SceneDescription PlayedBodies() => WithUnitys(Read(Played), out _);

    /// <summary>The box of the first body, also for a script, m.</summary>
    public Vector3d Edges => new Track(Bodies[0].Name, Bodies[0].Mass, ShapeOf(Bodies[0])).Edges;

    /// <summary>The drawn shape of a body: the solid box of Unity's inertia, where it is made of vertices.</summary>
    public MassProperties ShapeOf(Body body) => _file.SolidBoxes.GetValueOrDefault(body.Name, body.Mass);

    /// <summary>Adds a script's object beside the first body, or removes it.</summary>
    public void PutScript(bool isThere) => Script = isThere ? new ScriptBody(Bodies[0].Mass, _simulation.Scene.Bodies[0].Start) : null;

    /// <summary>One step with the keys held.</summary>
    /// <param name="held">A bit for each key.</param>
    public void Step(int held)
    {
        if (held != 0 && Scene.TakesKeys && Scene.TakenOver == null)
        {
            Scene.TakenOver = StepsDone;
            Begin();
        }

        if (Scene.TakenOver != null && Scene.Presses.Hold(held, StepsDone) && !_isPlain)
            Begin();

        _simulation.Step();
    }

    /// <summary>
    /// From the start to the present step: keys that have not been held change nothing before it. A keyboard is one push, and keys of a
    /// file are one each; locks and a mass that changes act on each push, with a rounding for each, so there every key is separate here, too.
    /// </summary>
    private void Begin()
    {
        long done = _simulation?.StepsDone ?? 0;
        _isPlain = Given.Bodies.All(body => body.Lock == Locks.None && !body.Effects.Any(effect => effect.Motion is MassRate));
        _file = Read(_isPlain ? Scene.Unpressed(MostSteps) : Scene.Text(MostSteps));
        HashSet<string> pushed = _isPlain && Scene.TakenOver != null ? [.. Scene.Pushed] : [];
        foreach (BodyDescription body in _file.Scene.Bodies.Where(body => pushed.Contains(body.Name)))
            body.With(new HeldKeys(Scene.Presses.Keyboard), Scene.HandedOver);

        _simulation = new Simulation(WithUnitys(_file, out IReadOnlyList<(int, int)> pairs));
        Pairs = pairs;
        _simulation.Step(done);
    }

    private SceneDescription WithUnitys(SceneFile file, out IReadOnlyList<(int First, int Second)> compared)
    {
        List<BodyDescription> bodies = [.. file.Scene.Bodies];
        IReadOnlyList<Pair> pairs = bodies.All(body => body.Rule == Rules.UnityRigidbody) ? [] : Pair.Of(file);
        foreach (Pair pair in pairs.Where(pair => _besideUnity && !bodies.Contains(pair.Default)))
            bodies.Insert(bodies.IndexOf(pair.Mine) + 1, pair.Default);

        compared = [.. pairs.Select(pair => (bodies.IndexOf(pair.Mine), bodies.IndexOf(pair.Default))).Where(pair => pair.Item2 >= 0)];
        return new SceneDescription(file.Scene.Name, file.Scene.About, file.Scene.Steps, bodies);
    }

    private SceneFile Read(string text)
    {
        File.WriteAllText(_path, text);
        return SceneReader.Read(_path);
    }
}
