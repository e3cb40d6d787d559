namespace RigidBodyDynamics.Lab;

/// <summary>
/// The advice for each body of a scene alone. Bodies do not interact, so each may have its own integrator and its own step; in
/// one scene they can have different integrators, but share the step.
/// </summary>
public sealed class BodyByBody
{
    private const double SecondsPerTurn = 0.001;
    private const int Turns = 40, MostShared = 100;

    private BodyByBody(IReadOnlyList<Advice> own, IReadOnlyList<Trial> oneRule, IReadOnlyList<Trial> oneStep)
    {
        Own = own;
        OneRule = oneRule;
        OneStep = oneStep;
    }

    /// <summary>For each body, in the order of the scene: the cheapest integrator and step, as if it were alone.</summary>
    public IReadOnlyList<Advice> Own { get; }

    /// <summary>The integrator and step advised for the whole scene, on each body; empty where there are none.</summary>
    public IReadOnlyList<Trial> OneRule { get; }

    /// <summary>For each body the cheapest integrator with one step length for all; empty where some body has none.</summary>
    public IReadOnlyList<Trial> OneStep { get; }

    /// <summary>True if there is an integrator below the bound for every body.</summary>
    public bool Reached => Own.All(advice => advice.Reached);

    /// <summary>Time for a simulated second of all bodies, s.</summary>
    public static double CostOf(IEnumerable<Trial> trials) => trials.Sum(trial => trial.Cost);

    /// <summary>Chooses for each body of a scene.</summary>
    /// <param name="scene">Converted by <see cref="StepFree"/>.</param>
    /// <param name="forAll">The advice for the whole scene.</param>
    /// <param name="error">The bound, as in <see cref="Advisor.Choose(SceneDescription, double, Action{double}?)"/>.</param>
    /// <param name="progress">Receives the finished fraction.</param>
    /// <remarks>
    /// Two common steps are tried: the longest that suits all bodies, not above the shortest of their own, and the step for the whole scene.
    /// Longer ones cost the body that needs the shortest step more than necessary, shorter ones cost all others more.
    /// </remarks>
    public static BodyByBody Of(SceneDescription scene, Advice forAll, double error, Action<double>? progress = null)
    {
        Guard.NotNull(forAll, nameof(forAll));
        SceneDescription[] alone = [.. Guard.NotNull(scene, nameof(scene)).Bodies.Select(body => new SceneDescription(body.Name, string.Empty, scene.Steps, [body]))];
        IReadOnlyList<IReadOnlyDictionary<Rule, double>> perStep = Probes.Of(alone, forAll.Truth.Duration);
        Advice[] own = new Advice[alone.Length];
        for (int i = 0; i < own.Length; i++)
        {
            int before = i;
            own[i] = Advisor.Choose(alone[i], forAll.Truth.Alone(i), error, perStep[i], done => progress?.Invoke(0.8 * (before + done) / alone.Length));
        }

        Trial[] oneRule = forAll.Reached
            ? [.. alone.Select((body, i) => Trial.Of(body, own[i].Truth, forAll.Best.Rule, forAll.Best.Step))]
            : [];
        List<Trial>[][] byStep = [.. StepsForAll(scene, own, forAll, step => AllBelow(alone, own, step, error)).OfType<List<Trial>[]>()];

        // trials whose costs are added or compared are timed in the same rounds
        Trial[] all = [.. own.Select(advice => advice.Best).Concat(oneRule).Concat(byStep.SelectMany(bodies => bodies).SelectMany(trials => trials)).Distinct()];
        StepClock.Take(all, SecondsPerTurn, Turns, done => progress?.Invoke(0.8 + 0.2 * done));
        return new BodyByBody(own, oneRule, byStep.Select(bodies => bodies.Select(Advisor.FirstOfCheapest).ToArray()).MinBy(CostOf) ?? []);
    }

    /// <summary>The trials below the bound, for the longest step that all bodies can share and for the step of the whole scene.</summary>
    private static IEnumerable<List<Trial>[]?> StepsForAll(SceneDescription scene, Advice[] own, Advice forAll, Func<double, List<Trial>[]?> allBelow)
    {
        if (!own.All(advice => advice.Reached))
            yield break;

        double shortest = own.Min(advice => advice.Best.Step);
        IEnumerable<double> shorter = StepSizes.Of(scene, forAll.Truth.Duration).Where(step => step < shortest).Take(MostShared);
        yield return shorter.Prepend(shortest).Select(allBelow).FirstOrDefault(bodies => bodies != null);

        if (forAll.Reached && forAll.Best.Step != shortest)
            yield return allBelow(forAll.Best.Step);
    }

    /// <summary>For every body the integrators below the bound with one step; null where a body has none.</summary>
    private static List<Trial>[]? AllBelow(SceneDescription[] alone, Advice[] own, double step, double error)
    {
        List<Trial>[] below = new List<Trial>[alone.Length];
        // a body whose own step is short is the likeliest to have none
        foreach (int i in Enumerable.Range(0, alone.Length).OrderBy(i => own[i].Best.Step))
        {
            below[i] = Below(alone[i], own[i], step, error);
            if (below[i].Count == 0)
                return null;
        }

        return below;
    }

    /// <summary>The integrators below the bound for a body; for its own step only its own integrator, which is known to be the cheapest.</summary>
    private static List<Trial> Below(SceneDescription alone, Advice own, double step, double error) => own.Best.Step == step
        ? [own.Best]
        : [.. Rules.All.Select(rule => Trial.Of(alone, own.Truth, rule, step, error, toItsEnd: false)).Where(trial => Advisor.IsBelow(trial, own.Truth, error))];
}
