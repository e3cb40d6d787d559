namespace RigidBodyDynamics.Tests;

/// <summary>A simulation in which a <see cref="Life"/> runs: some of its bodies, by number.</summary>
internal sealed class LivedWorld(bool inSingleSteps, bool looks)
{
    private readonly Dictionary<int, Body> _bodies = [];
    private (SavedSimulation Simulation, Dictionary<int, Body> Bodies)? _saved;

    public Simulation Simulation { get; } = new(TimeSteps.Every(1 / 64.0));

    public IReadOnlyDictionary<int, Body> Bodies => _bodies;

    /// <summary>The operations since the last reading, for a model that repeats them by other means.</summary>
    public List<(string What, double Length, int Body, Vector3d A, Vector3d? B, bool InBody)> Done { get; } = [];

    public void Step(long count)
    {
        for (int n = 0; inSingleSteps && n < count; n++)
            Simulation.Step();

        if (!inSingleSteps)
            Simulation.Step(count);

        for (int n = 0; n < count; n++)
            Note("step", 1 / 64.0);
    }

    public void StepBy(double length)
    {
        Simulation.StepBy(length);
        Note("step", length);
    }

    public void Advance(double elapsed)
    {
        long count = Simulation.Advance(elapsed);
        for (int n = 0; n < count; n++)
            Note("step", 1 / 64.0);
    }

    public void Impulse(int body, Vector3d impulse, Vector3d? point, bool inBody) => With(body, it =>
    {
        if (point == null)
            it.ApplyImpulse(impulse, inBody);
        else
            it.ApplyImpulse(impulse, point.Value, inBody);

        Note("impulse", 0, body, impulse, point, inBody);
    });

    public void AngularImpulse(int body, Vector3d impulse, bool inBody) => With(body, it =>
    {
        it.ApplyAngularImpulse(impulse, inBody);
        Note("angular impulse", 0, body, impulse, null, inBody);
    });

    public void Force(int body, Vector3d force, bool inBody) => With(body, it =>
    {
        it.ApplyForce(force, inBody);
        Note("force", 0, body, force, null, inBody);
    });

    public void Torque(int body, Vector3d torque, bool inBody) => With(body, it =>
    {
        it.ApplyTorque(torque, inBody);
        Note("torque", 0, body, torque, null, inBody);
    });

    public void Set(int body, BodyState state) => With(body, it =>
    {
        it.State = state;
        Note("anew", 0, body);
    });

    public void Change(int body, BodyDescription next, Keeping keeping) => With(body, it =>
    {
        it.Change(next, keeping);
        Note("anew", 0, body);
    });

    public void Add(int number, BodyDescription description)
    {
        _bodies.Add(number, Simulation.Add(description));
        Note("anew", 0, number);
    }

    public void Remove(int body) => With(body, it =>
    {
        Simulation.Remove(it);
        _bodies.Remove(body);
    });

    public void Look(int body, double alpha)
    {
        if (looks)
            With(body, it => _ = (it.State, it.Between(alpha)));
    }

    /// <summary>Saves all, or goes back to the last save, if there is one.</summary>
    public void SaveOrRestore(bool saves)
    {
        if (saves || _saved == null)
        {
            _saved = (Simulation.Save(), new Dictionary<int, Body>(_bodies));
            Note("save", 0);
            return;
        }

        Simulation.Restore(_saved.Value.Simulation);
        _bodies.Clear();
        foreach ((int number, Body body) in _saved.Value.Bodies)
            _bodies.Add(number, body);

        Note("restore", 0);
    }

    private void Note(string what, double length, int body = -1, Vector3d a = default, Vector3d? b = null, bool inBody = false) =>
        Done.Add((what, length, body, a, b, inBody));

    private void With(int number, Action<Body> act)
    {
        if (_bodies.TryGetValue(number, out Body? body))
            act(body);
    }
}
