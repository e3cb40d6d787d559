namespace RigidBodyDynamics.Lab.Bench;

/// <summary>The operations of a game: one step a frame, and reading, pushing, setting, adding and removing one body of many.</summary>
internal static class LivingSuite
{
    // so many steps a call that the overhead of a call is negligible
    private const long Together = 1000;

    // enough that no chosen body is still in the cache
    private const int Picks = 1 << 18;

    /// <summary>One step a call and a thousand steps a call, and the cost of an effect that gives zero.</summary>
    public static IReadOnlyList<Measurement> Calls()
    {
        List<Measurement> all = [];
        foreach (Rule rule in new[] { Rules.Exact, Rules.LabEuler })
        {
            foreach ((string what, Func<BodyDescription> body) in new (string, Func<BodyDescription>)[]
            {
                ("free", () => Body(rule)),
                ("falls", () => Falling(rule)),
                ("falls, and is pushed by nothing", () => Falling(rule).With(new NoPush())),
            })
            {
                all.Add(new Measurement($"{rule.Name}, {what}, {Together} steps a call", 1, 1, () => ManySteps(Of(body()))));
                all.Add(new Measurement($"{rule.Name}, {what}, a step a call", 1, 1, () => OneByOne(Of(body()).Step)));
            }
        }

        return all;
    }

    /// <summary>Operations on one of many bodies that are stored together, chosen at random: most of them are not in the cache.</summary>
    /// <param name="bodies">The number of bodies.</param>
    public static IReadOnlyList<Measurement> OneOf(int bodies)
    {
        Lazy<(Simulation Simulation, Body[] Bodies)> many = new(() => Many(bodies));
        BodyState start = Body(Rules.Exact).Start;
        BodyDescription like = Body(Rules.Exact);
        bool gone = false;
        BodyState seen = start;
        Vector3d impulse = new(0.1, 0, 0), point = new(1, 0, 0);
        return
        [
            One("ask the handle", (_, body) => gone |= body.IsRemoved),
            One("read", (_, body) => seen = body.State),
            One("push", (_, body) => body.ApplyImpulse(impulse)),
            One("eccentric push", (_, body) => body.ApplyImpulse(impulse, point, inBody: true)),
            One("set", (_, body) => body.State = start),
            One("remove and bring back", (simulation, body) =>
            {
                simulation.Remove(body);
                simulation.Add(body, start);
            }),
            One("add another and remove it", (simulation, _) => simulation.Remove(simulation.Add(like, start))),
        ];

        Measurement One(string what, Action<Simulation, Body> act) => new(NameOf(what, bodies), 1, 1, () => At(many.Value, act));
    }

    /// <summary>The name of an operation on one of many bodies.</summary>
    public static string NameOf(string what, int bodies) => FormattableString.Invariant($"one of {bodies:N0}: {what}");

    private static Action<long> At((Simulation Simulation, Body[] Bodies) many, Action<Simulation, Body> act)
    {
        Random random = new(1);
        int[] picks = [.. Enumerable.Range(0, Picks).Select(_ => random.Next(many.Bodies.Length))];
        int next = 0;
        return count =>
        {
            for (; count > 0; count--)
                act(many.Simulation, many.Bodies[picks[next++ & (Picks - 1)]]);
        };
    }

    private static (Simulation Simulation, Body[] Bodies) Many(int bodies)
    {
        Simulation simulation = new(TimeSteps.Every(0.02)) { Threads = 1 };
        BodyDescription like = Body(Rules.Exact).With(new Torque(new Vector3d(1, 0, 0), Vector3d.Zero, new Vector3d(0, 1, 0), 1, inBody: false));
        Body[] all = new Body[bodies];
        for (int i = 0; i < bodies; i++)
            all[i] = simulation.Add(like, new BodyState(new Vector3d(i, 0, 0), Quaterniond.Identity, like.Start.Velocity, new Vector3d(1, 1.1 + i / (10.0 * bodies), 0.9)));

        simulation.Step();
        return (simulation, all);
    }

    private static Action<long> ManySteps(Simulation simulation) => count =>
    {
        for (; count > 0; count -= Together)
            simulation.Step(Math.Min(count, Together));
    };

    private static Action<long> OneByOne(Action step) => count =>
    {
        for (; count > 0; count--)
            step();
    };

    private static Simulation Of(BodyDescription body) =>
        new(new SceneDescription("bench", string.Empty, TimeSteps.Every(0.02), [body]), Omissions.All & ~Omissions.Coasting);

    private static BodyDescription Falling(Rule rule) => Body(rule).With(new Gravity(new Vector3d(0, -9.81, 0)));

    private static BodyDescription Body(Rule rule) => new("body", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)))
    {
        Rule = rule,
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
    };

    /// <summary>An effect that declares a force and a torque, and gives zero.</summary>
    private readonly struct NoPush : IPush
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) { }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) { }
    }
}
