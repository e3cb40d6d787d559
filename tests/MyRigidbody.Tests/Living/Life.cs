namespace RigidBodyDynamics.Tests;

/// <summary>A random sequence of operations on a simulation and its bodies, generated once and repeatable.</summary>
internal sealed class Life
{
    private readonly List<(int Body, Action<LivedWorld> Do)> _told = [];
    private readonly Random _random;
    private readonly string[] _rules;
    private readonly bool _isFree;
    private int _bodies;

    /// <param name="seed">The seed of the sequence.</param>
    /// <param name="operations">The number of operations.</param>
    /// <param name="rules">The integrators of the bodies, chosen at random.</param>
    /// <param name="isFree">True for bodies with a closed form: only gravity and damping act on them.</param>
    public Life(int seed, int operations, string[] rules, bool isFree = false)
    {
        _random = new Random(seed);
        _rules = rules;
        _isFree = isFree;
        for (int i = 0; i < 3; i++)
            Add();

        while (_told.Count < operations)
            Tell();
    }

    /// <summary>The number of bodies ever added.</summary>
    public int Bodies => _bodies;

    /// <summary>Runs it, with all bodies or with one of them, and checks after each operation.</summary>
    public LivedWorld Live(int? only = null, bool inSingleSteps = false, bool looks = true, Action<LivedWorld>? after = null)
    {
        LivedWorld world = new(inSingleSteps, looks);
        foreach ((int body, Action<LivedWorld> act) in _told)
        {
            // only present bodies are pushed, and only added ones are removed
            if (body >= 0 && only != null && body != only)
                continue;

            act(world);
            after?.Invoke(world);
        }

        return world;
    }

    private void Tell()
    {
        int body = _random.Next(_bodies);
        Vector3d a = Vector(), b = Vector();
        bool inBody = _random.Next(2) == 0;
        switch (_random.Next(17))
        {
            case 0 or 1:
                long count = _random.Next(1, _random.Next(4) == 0 ? 300 : 8);
                _told.Add((-1, world => world.Step(count)));
                break;
            case 2:
                double length = 0.001 + 0.03 * _random.NextDouble();
                _told.Add((-1, world => world.StepBy(length)));
                break;
            case 3:
                double frame = 0.07 * _random.NextDouble();
                _told.Add((-1, world => world.Advance(frame)));
                break;
            case 4:
                With(body, world => world.Impulse(body, a, null, inBody));
                break;
            case 5:
                With(body, world => world.Impulse(body, a, b, inBody));
                break;
            case 6:
                With(body, world => world.AngularImpulse(body, a, inBody));
                break;
            case 7 or 8:
                With(body, world => world.Force(body, a, inBody));
                break;
            case 9 or 10:
                With(body, world => world.Torque(body, a, inBody));
                break;
            case 11:
                BodyState state = State();
                With(body, world => world.Set(body, state));
                break;
            case 12:
                BodyDescription next = Description("changed");
                Keeping keeping = inBody ? Keeping.Momentum : Keeping.Velocity;
                With(body, world => world.Change(body, next, keeping));
                break;
            case 13:
                Add();
                break;
            case 14:
                With(body, world => world.Remove(body));
                break;
            case 15:
                double alpha = _random.NextDouble();
                With(body, world => world.Look(body, alpha));
                break;
            default:
                bool saves = inBody;
                _told.Add((-1, world => world.SaveOrRestore(saves)));
                break;
        }
    }

    private void With(int body, Action<LivedWorld> act) => _told.Add((body, act));

    private void Add()
    {
        int number = _bodies++;
        BodyDescription description = Description("body " + number);
        _told.Add((number, world => world.Add(number, description)));
    }

    private BodyDescription Description(string name)
    {
        string rule = _rules[_random.Next(_rules.Length)];
        PointBody points = PointBody.All[_random.Next(PointBody.All.Length)];
        bool isBusy = !_isFree && _random.Next(3) == 0;
        BodyDescription like = isBusy ? Scenery.Busy(rule) : Scenery.Body(rule);
        BodyDescription description = like.Copy(name, points.Mass);
        description.Start = _random.Next(4) == 0 ? BodyState.AtRest : State();
        if (_random.Next(2) == 0)
            description.With(new Gravity(0.1 * Vector()));

        if (_random.Next(2) == 0)
            description.With(new LinearDamping(_random.NextDouble())).With(new AngularDamping(0.3 * _random.NextDouble()));

        return description;
    }

    private BodyState State() => new(Vector(), new Quaterniond(Uniform() + 2, Vector()).Normalized, Vector(), Vector());

    private Vector3d Vector() => new(Uniform(), Uniform(), Uniform());

    private double Uniform() => 4 * _random.NextDouble() - 2;
}
