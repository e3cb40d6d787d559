namespace RigidBodyDynamics.Lab;

/// <summary>
/// What is advised for each body of a scene by itself. Bodies do not feel each other, so each may have its own rule and
/// its own step; in one scene they have rules of their own, but share the step.
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

    /// <summary>For each body, in the order of the scene: the cheapest rule and step, as if it were alone.</summary>
    public IReadOnlyList<Advice> Own { get; }

    /// <summary>The rule and step that were advised for all, on each body; empty where there are none.</summary>
    public IReadOnlyList<Trial> OneRule { get; }

    /// <summary>For each body the cheapest rule in steps of one length for all; empty where some body has none.</summary>
    public IReadOnlyList<Trial> OneStep { get; }

    /// <summary>True if every body by itself is kept below the bound.</summary>
    public bool Reached => Own.All(advice => advice.Reached);

    /// <summary>Time for a simulated second of all bodies, s.</summary>
    public static double CostOf(IEnumerable<Trial> trials) => trials.Sum(trial => trial.Cost);

    /// <summary>Chooses for each body of a scene.</summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="forAll">What is advised for the scene as a whole.</param>
    /// <param name="error">The bound, as in <see cref="Advisor.Choose(SceneDescription, double, Action{double}?)"/>.</param>
    /// <param name="progress">Told the fraction that is done.</param>
    /// <remarks>
    /// Two steps are tried for all: the longest that all can take, not above the shortest of their own, and that of the one rule. In longer
    /// ones the body that needs the shortest would pay more than it must, in shorter ones all others would.
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

        // what is added up and compared is timed in the same turns
        Trial[] all = [.. own.Select(advice => advice.Best).Concat(oneRule).Concat(byStep.SelectMany(bodies => bodies).SelectMany(trials => trials)).Distinct()];
        StepClock.Take(all, SecondsPerTurn, Turns, done => progress?.Invoke(0.8 + 0.2 * done));
        return new BodyByBody(own, oneRule, byStep.Select(bodies => bodies.Select(Advisor.FirstOfCheapest).ToArray()).MinBy(CostOf) ?? []);
    }

    /// <summary>What keeps the bodies below the bound, in the longest step that all can share and in that of the one rule.</summary>
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

    /// <summary>For every body the rules that keep it below the bound in a step; null where one has none.</summary>
    private static List<Trial>[]? AllBelow(SceneDescription[] alone, Advice[] own, double step, double error)
    {
        List<Trial>[] below = new List<Trial>[alone.Length];
        // who takes short steps by itself is the likeliest to have none
        foreach (int i in Enumerable.Range(0, alone.Length).OrderBy(i => own[i].Best.Step))
        {
            below[i] = Below(alone[i], own[i], step, error);
            if (below[i].Count == 0)
                return null;
        }

        return below;
    }

    /// <summary>The rules that keep a body below the bound; in its own step only its own, which is known to be the cheapest.</summary>
    private static List<Trial> Below(SceneDescription alone, Advice own, double step, double error) => own.Best.Step == step
        ? [own.Best]
        : [.. Rules.All.Select(rule => Trial.Of(alone, own.Truth, rule, step, error, toItsEnd: false)).Where(trial => Advisor.IsBelow(trial, own.Truth, error))];
}
