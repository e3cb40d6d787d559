using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds out by trying, at load time, by which rule and in which steps a scene should run.</summary>
public static class Advisor
{
    /// <summary>Costs that differ by no more than this factor are the same to the clock; the rule that stands first is then taken.</summary>
    public const double SameCost = 1.03;

    // both are measured once and may be luckily small, and masses and forces have last bits too
    private const double Doubt = 4;

    // a step of a rule that is so much dearer than the second best, or than the best, is not looked for
    private const double FarDearer = 3, FarDearerThanBest = 20, ManyBits = 1e-9;

    /// <summary>The cheapest rule and step that keep a scene's error below a bound.</summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="error">The bound on the larger of the angle (rad) and the distance (m) to the true motion, at any time.</param>
    /// <param name="progress">Told the fraction that is done.</param>
    /// <remarks>
    /// For every rule of the catalogue the longest step in which the error, with what the truth itself is uncertain by, is below the bound;
    /// then the time of those. A rule is given up where its steps cost far more than the best of the others.
    /// </remarks>
    public static Advice Choose(SceneDescription scene, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Truth truth = Truth.Of(scene, done => progress?.Invoke(0.4 * done), error);
        return Choose(scene, truth, error, done => progress?.Invoke(0.4 + 0.6 * done));
    }

    /// <summary>The same where the motion is known already.</summary>
    public static Advice Choose(SceneDescription scene, Truth truth, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Guard.NotNull(truth, nameof(truth));
        return Choose(scene, truth, error, Probes.Of([scene], truth.Duration)[0], progress);
    }

    /// <summary>The same where it is known what a step of each rule costs, ns.</summary>
    internal static Advice Choose(
        SceneDescription scene, Truth truth, double error, IReadOnlyDictionary<Rule, double> perStep, Action<double>? progress)
    {
        progress?.Invoke(0.1);
        StepSearch search = new StepSearch(scene, truth, error);
        List<Trial> below = [];
        foreach ((Rule rule, int done) in Rules.All.OrderByDescending(rule => rule.Order).Select((rule, i) => (rule, i + 1)))
        {
            double[] costs = [.. below.Select(trial => trial.Cost).Order()];
            double most = costs.Length > 1 ? FarDearer * costs[1] : costs.Length > 0 ? FarDearerThanBest * costs[0] : double.PositiveInfinity;
            Trial? longest = search.Longest(rule, step => 1e-9 * perStep[rule] / step > most);
            if (longest != null)
            {
                longest.NanosecondsPerStep = perStep[rule];
                below.Add(longest);
            }

            progress?.Invoke(0.1 + 0.7 * done / Rules.All.Count);
        }

        if (below.Count == 0)
            return new Advice(truth, search.Closest!, Why(truth, search, error));

        // as in the catalogue: of those that cost the same the first is taken
        Trial[] inOrder = [.. Rules.All.SelectMany(rule => below.Where(trial => trial.Rule == rule))];
        return new Advice(truth, new Contest(inOrder, done => progress?.Invoke(0.8 + 0.2 * done)));
    }

    /// <summary>True if a trial keeps the bound, whatever the truth is uncertain by and the last bit of the start changes.</summary>
    internal static bool IsBelow(Trial trial, Truth truth, double error) => trial.Error + Doubt * (truth.Uncertainty + truth.Floor) < error;

    /// <summary>The cheapest of some trials whose time was taken; of those that cost the same, the one that stands first.</summary>
    internal static Trial FirstOfCheapest(List<Trial> trials) => trials.First(trial => trial.Cost <= SameCost * Cheapest(trials)!.Cost);

    private static Trial? Cheapest(List<Trial> trials) => trials.MinBy(trial => trial.Cost);

    private static string Why(Truth truth, StepSearch search, double error)
    {
        if (truth.Floor >= error && truth.Floor > ManyBits)
            return Words("chaos: the last bit of the start alone moves the answer by {0:0.0e+0}", truth.Floor);

        if (truth.Floor < error && Doubt * (truth.Uncertainty + truth.Floor) >= error)
            return Words("the reference: the motion itself could only be found to {0:0.0e+0}", truth.Uncertainty);

        if (truth.Floor >= error || (search.RisesAgain && search.Closest!.Error < ManyBits))
            return Words("rounding floor, about {0:0.0e+0}: below it the last bits decide, and shorter steps only round more often", truth.Floor);

        return Words("the step: {0:R} s is the shortest that was tried, and still too long", search.Closest!.Step)
            + (search.MeetsEffects ? string.Empty : "; none meets all the times at which effects begin and end");
    }

    private static string Words(string format, double value) => string.Format(CultureInfo.InvariantCulture, format, value);
}
