namespace RigidBodyDynamics.Tests;

/// <summary>Bodies that a simulation stores and steps together, by the order in which they were added.</summary>
internal sealed class Together
{
    private readonly Simulation _simulation;
    private readonly BodyDescription _like;
    private readonly List<Body> _bodies = [];
    private BodyState[] _read = [];

    public Together(BodyDescription body, TimeSteps steps, Omissions mayLeaveOut = Omissions.Coasting)
    {
        _like = body.Copy(body.Name, body.Mass);
        _simulation = new(new SceneDescription("together", "", steps, []), mayLeaveOut);
        // the first of a kind is moved alone
        _simulation.Remove(_simulation.Add(_like));
    }

    public int Count => _simulation.Bodies.Count;

    public int EndOfIds => _bodies.Count;

    public long StepsDone => _simulation.StepsDone;

    public int Threads
    {
        get => _simulation.Threads;
        set => _simulation.Threads = value;
    }

    public BodyState this[int id] => _bodies[id].State;

    public int Add(in BodyState start)
    {
        _bodies.Add(_simulation.Add(_like, start));
        return _bodies.Count - 1;
    }

    public int Add(in BodyState start, Vector3d angularVelocityInBody)
    {
        _like.Start = start;
        _like.AngularVelocityInBody = angularVelocityInBody;
        _bodies.Add(_simulation.Add(_like));
        return _bodies.Count - 1;
    }

    public void Remove(int id) => _simulation.Remove(_bodies[id]);

    /// <summary>One that was removed comes back.</summary>
    public void Return(int id, in BodyState start) => _simulation.Add(_bodies[id], start);

    /// <summary>The number of a body here.</summary>
    public int IdOf(Body body) => _bodies.IndexOf(body);

    /// <summary>All at once.</summary>
    public void Read(BodyState[] states)
    {
        if (_read.Length < Count)
            _read = new BodyState[2 * Count];

        _simulation.ReadStates(_read);
        for (int i = 0; i < _bodies.Count; i++)
        {
            if (!_bodies[i].IsRemoved)
                states[i] = _read[_bodies[i].Index];
        }
    }

    public void Step(long count = 1) => _simulation.Step(count);
}
