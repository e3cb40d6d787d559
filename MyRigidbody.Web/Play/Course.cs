using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Play;

/// <summary>A played scene in motion: its bodies, Unity's beside those that have none in the file, and the script's.</summary>
internal sealed class Course
{
    /// <summary>Steps that are played and kept: 20 minutes of the lab's.</summary>
    public const long MostSteps = 60_000;

    private readonly string _path;
    private readonly bool _besideUnity;
    private bool _isPlain;
    private SceneFile _file = null!;
    private Simulation _simulation = null!;

    /// <summary>A scene at its start.</summary>
    /// <param name="path">Its file, beside the meshes that it names.</param>
    /// <param name="text">What is in it.</param>
    /// <param name="rule">The rule of all bodies that are not Unity's; null for those of the file.</param>
    /// <param name="besideUnity">Whether a body that has no body of Unity's beside it gets one, as <c>compare</c> does.</param>
    /// <param name="ownKeys">Whether the reader's keys are all, and those of the file are left out.</param>
    /// <exception cref="InputException">What is wrong with the file, in one line.</exception>
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

    /// <summary>The scene as it is in the file.</summary>
    public SceneDescription Given { get; }

    /// <summary>What is played.</summary>
    public PlayedScene Scene { get; }

    /// <summary>The bodies, without the script's.</summary>
    public IReadOnlyList<Body> Bodies => _simulation.Bodies;

    /// <summary>Which of them are compared.</summary>
    public IReadOnlyList<(int First, int Second)> Pairs { get; private set; } = [];

    /// <summary>Beside them.</summary>
    public ScriptBody? Script { get; private set; }

    /// <summary>How many steps are done.</summary>
    public long StepsDone => _simulation.StepsDone;

    /// <summary>Time since the start, s.</summary>
    public double Time => _simulation.Time;

    /// <summary>How many steps there can be.</summary>
    public long Count => _simulation.Scene.Steps.Count;

    /// <summary>The scene file of what has been played.</summary>
    public string Played => Scene.Text(Math.Max(1, StepsDone));

    /// <summary>The scene file as it was given, with the rule that was chosen.</summary>
    public string Chosen => Scene.Unpressed(Given.Steps.Count);

    /// <summary>What has been played, read from its scene file, with the bodies of Unity's.</summary>
    public SceneDescription PlayedBodies() => WithUnitys(Read(Played), out _);

    /// <summary>The box that is drawn of the first body, and that a script is put on, m.</summary>
    public Vector3d Edges => new Track(Bodies[0].Name, Bodies[0].Mass, ShapeOf(Bodies[0])).Edges;

    /// <summary>What is drawn of a body: the solid box of Unity's inertia, where it is made of vertices.</summary>
    public MassProperties ShapeOf(Body body) => _file.SolidBoxes.GetValueOrDefault(body.Name, body.Mass);

    /// <summary>Puts a script's object beside the first body, or takes it away.</summary>
    public void PutScript(bool isThere) => Script = isThere ? new ScriptBody(Bodies[0].Mass, _simulation.Scene.Bodies[0].Start) : null;

    /// <summary>One step, by the keys that are held.</summary>
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
    /// From the start to where it has come: keys that nobody has held yet change nothing before that. A keyboard is one push, and keys of a
    /// file are one each; locks and a mass that changes act on each push by itself, and round each, so there every key is its own here too.
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
