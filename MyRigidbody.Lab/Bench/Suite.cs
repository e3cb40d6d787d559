namespace RigidBodyDynamics.Lab.Bench;

/// <summary>The measurements of bench: groups that are compared.</summary>
internal static class Suite
{
    private const double Step = 0.02;

    // the start of an effect that is in the scene and does not act during the bench
    private const double Never = 1e8;

    /// <summary>The lab's step by the library and written by hand.</summary>
    public static IReadOnlyList<Measurement> ByHand()
    {
        Vector3d gravity = new(0, -9.81, 0), force = new(5, 1, 2);
        BodyDescription cube = Body("LabEuler", new Vector3d(0.5, 0.5, 0.5))
            .With(new Gravity(gravity)).With(new DecayPerStep(0.98, 0.98)).With(new Force(force)).With(new KeyPush(LabKey.R));
        return
        [
            Alone("lab's step, written by hand", new HandWritten(cube.Start, cube.Mass, force, gravity, 0.98, Step).Go()),
            Alone("lab's step, by the library", cube),
        ];
    }

    /// <summary>A body without pushes, by every integrator.</summary>
    public static IReadOnlyList<Measurement> ByRule() =>
        [.. Rules.All.Select(rule => Alone("free body by " + rule.Name, Body(rule.Name, new Vector3d(1, 2, 3))))];

    /// <summary>
    /// A torque, constant and oscillating, by Exact and by RungeKutta4: its first twenty seconds again and again. A body under a lasting torque
    /// would soon rotate so fast that RungeKutta4 no longer follows the motion, though its cost stays the same.
    /// </summary>
    public static IReadOnlyList<Measurement> Torques() =>
    [
        .. from rule in new[] { "Exact", "RungeKutta4" }
           from torque in new[]
           {
               ("a constant torque", Torque.Constant(new Vector3d(0.1, 0.2, 0.3))),
               ("a torque by sin t", new Torque(new Vector3d(0, 0, 0.1), new Vector3d(0.3, 0, 0), new Vector3d(0, 0.2, 0), 1, inBody: false)),
           }
           select new Measurement($"{rule}, {torque.Item1}", 1, 1, () => Again(Of(Body(rule, new Vector3d(1, 2, 3)).With(torque.Item2), Omissions.None), 1000)),
    ];

    /// <summary>Each effect acting, in the scene but idle, and absent.</summary>
    public static IReadOnlyList<Measurement> Effects()
    {
        (string Name, Func<BodyDescription, double, BodyDescription> With)[] effects =
        [
            ("gravity", (body, from) => body.With(new Gravity(new Vector3d(0, -9.81, 0)), from)),
            ("linear damping", (body, from) => body.With(new LinearDamping(0.01), from)),
            ("angular damping", (body, from) => body.With(new AngularDamping(0.01), from)),
            ("force", (body, from) => body.With(new Force(new Vector3d(1, 0, 0)), from)),
            ("torque", (body, from) => body.With(new Torque(new Vector3d(0.01, 0, 0), Vector3d.Zero, Vector3d.Zero, 0, true), from)),
            ("drag", (body, from) => body.With(new QuadraticDrag(0.01), from)),
            ("spring", (body, from) => body.With(new Spring(new Vector3d(0, 0.1, 0), Vector3d.Zero, 1), from)),
        ];
        return
        [
            Alone("Exact, no effect", General()),
            Alone("Exact, no effect, again", General()),
            .. effects.SelectMany(effect => new[]
            {
                Alone($"Exact, {effect.Name} on", effect.With(General(), 0)),
                Alone($"Exact, {effect.Name} idle", effect.With(General(), Never)),
            }),
            Alone("Exact, gravity and keys that are not held", General().With(new Gravity(new Vector3d(0, -9.81, 0))).With(new HeldKeys(new LabKeyboard()))),
        ];
    }

    /// <summary>The cost of bodies of different symmetry.</summary>
    public static IReadOnlyList<Measurement> Shapes()
    {
        BodyDescription held = General(), asleep = Body("UnityRigidbody", new Vector3d(1, 2, 3));
        held.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), Vector3d.Zero);
        asleep.Start = BodyState.AtRest;
        BodyDescription lying = General();
        lying.Start = BodyState.AtRest;
        return
        [
            Alone("Exact, three different moments", General()),
            Alone("Exact, two equal moments", Body("Exact", new Vector3d(1, 1, 0.5))),
            Alone("Exact, three equal moments", Body("Exact", new Vector3d(1, 1, 1))),
            Alone("Exact, no spin", held),
            Unseen("Exact, coasting, state not read", General()),
            Unseen("Exact, at rest", lying),
            Unseen("UnityRigidbody, asleep", asleep),
        ];
    }

    /// <summary>A velocity that has been damped for a hundred thousand steps, and a new one.</summary>
    public static IReadOnlyList<Measurement> Denormals() =>
    [
        .. from rule in new[] { "LabEuler", "Exact" }
           from steps in new[] { 0L, 100_000 }
           select new Measurement($"{rule}, damped for {steps} steps", 1, 1, () =>
           {
               Simulation simulation = Of(Body(rule, new Vector3d(1, 2, 3)).With(new DecayPerStep(0.98, 0.98)), Omissions.None);
               simulation.Step(steps);
               // restarted often, so that its velocity stays far from zero
               return Again(simulation, 200);
           }),
    ];

    /// <summary>Many bodies one by one and together, by one thread and two, and the bandwidth of memory.</summary>
    public static IReadOnlyList<Measurement> Many(int bodies)
    {
        List<Measurement> all = [];
        foreach ((string what, Func<BodyDescription> like) in new (string, Func<BodyDescription>)[]
        {
            ("Exact, three moments", General),
            ("LabEuler", () => Body("LabEuler", new Vector3d(1, 2, 3))),
            ("translation", () => Held()),
        })
        {
            if (bodies <= 100_000)
                all.Add(new Measurement(what + ", one by one", bodies, 1, () => Of(like, bodies).Step));

            foreach (int threads in new[] { 1, 2 })
                all.Add(new Measurement(what + ", together", bodies, threads, () => Together(like(), bodies, threads, Omissions.None).Step));
        }

        if (bodies <= 100_000)
            all.Add(new Measurement("Exact, three moments, described one by one", bodies, 1, () => Described(bodies).Step));

        all.Add(new Measurement("Exact, three moments, all states read", bodies, 1, () => Reading(Together(General(), bodies, 1, Omissions.None))));
        foreach (int threads in new[] { 1, 2 })
        {
            all.Add(new Measurement("in-place scale of 13 doubles a body", bodies, threads, () => InPlaceScale.Of(13 * bodies, threads)));
            all.Add(new Measurement("in-place scale of 26 doubles a body", bodies, threads, () => InPlaceScale.Of(26 * bodies, threads)));
        }


        all.Add(new Measurement("Exact, coasting, state not read, together", bodies, 1, () => OneByOne(Together(General(), bodies, 1, Omissions.All).Step)));
        return all;
    }

    private static Measurement Alone(string what, BodyDescription body, Omissions mayLeaveOut = Omissions.All & ~Omissions.Coasting) =>
        new(what, 1, 1, () => Of(body, mayLeaveOut).Step);

    // one step a call, as in a game, so that coasting saves nothing within a call
    private static Measurement Unseen(string what, BodyDescription body) => new(what, 1, 1, () => OneByOne(Of(body, Omissions.All).Step));

    /// <summary>A number of steps from the present state, again and again.</summary>
    private static Action<long> Again(Simulation simulation, long steps)
    {
        SavedSimulation saved = simulation.Save();
        return count =>
        {
            for (; count > 0; count -= steps)
            {
                simulation.Restore(saved);
                simulation.Step(Math.Min(count, steps));
            }
        };
    }

    private static Action<long> OneByOne(Action<long> step) => count =>
    {
        for (long i = 0; i < count; i++)
            step(1);
    };

    private static Measurement Alone(string what, Func<Action<long>> make) => new(what, 1, 1, make);

    private static Simulation Of(BodyDescription body, Omissions mayLeaveOut) =>
        new(new SceneDescription("bench", string.Empty, TimeSteps.Every(Step), [body]), mayLeaveOut);

    private static Simulation Of(Func<BodyDescription> like, int bodies)
    {
        BodyDescription[] all = new BodyDescription[bodies];
        for (int i = 0; i < bodies; i++)
        {
            BodyDescription body = like();
            all[i] = body.Copy("body " + i, body.Mass);
            all[i].Start = Start(i, body);
        }

        return new Simulation(new SceneDescription("bench", string.Empty, TimeSteps.Every(Step), all), Omissions.All & ~Omissions.Coasting);
    }

    /// <summary>Bodies that are added with a description each, as a game does that knows nothing of crowds.</summary>
    private static Simulation Described(int bodies)
    {
        Simulation simulation = new(new SceneDescription("bench", string.Empty, TimeSteps.Every(Step), []), Omissions.All & ~Omissions.Coasting) { Threads = 1 };
        for (int i = 0; i < bodies; i++)
            simulation.Add(General(), Start(i, General()));

        return simulation;
    }

    private static Action<long> Reading(Simulation simulation)
    {
        BodyState[] states = new BodyState[simulation.Bodies.Count];
        return count =>
        {
            for (long i = 0; i < count; i++)
                simulation.ReadStates(states);
        };
    }

    private static Simulation Together(BodyDescription body, int bodies, int threads, Omissions mayLeaveOut)
    {
        Simulation simulation = new(new SceneDescription("bench", string.Empty, TimeSteps.Every(Step), []), mayLeaveOut) { Threads = threads };
        for (int i = 0; i < bodies; i++)
            simulation.Add(body, Start(i, body));

        return simulation;
    }

    // different starts, so that no two bodies move alike
    private static BodyState Start(int i, BodyDescription body)
    {
        BodyState start = body.Start;
        double part = (i % 1000) / 1000.0;
        start.Velocity += part * start.Velocity;
        start.AngularVelocity += 0.3 * part * start.AngularVelocity;
        return start;
    }

    private static BodyDescription General() => Body("Exact", new Vector3d(1, 2, 3));

    private static BodyDescription Held()
    {
        BodyDescription body = General();
        body.CanTurn = false;
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), Vector3d.Zero);
        return body;
    }

    private static BodyDescription Body(string rule, Vector3d moments) => new("body", MassProperties.FromPrincipal(1, moments))
    {
        Rule = Rules.Named(rule),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
        Unity = new UnitySettings { MaxAngularVelocity = double.PositiveInfinity },
    };
}
