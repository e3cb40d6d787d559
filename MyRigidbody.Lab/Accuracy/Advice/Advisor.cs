using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds by trial runs, at load time, the integrator and the step length for a scene.</summary>
public static class Advisor
{
    /// <summary>Costs whose ratio is at most this factor count as equal; the integrator that is first in the catalogue is then chosen.</summary>
    public const double SameCost = 1.03;

    // the uncertainty and the floor are measured once and may be small by chance, and masses and forces have last bits, too
    private const double Doubt = 4;

    // no step is searched for an integrator that costs this factor more than the second best, or than the best
    private const double FarDearer = 3, FarDearerThanBest = 20, ManyBits = 1e-9;

    /// <summary>The cheapest integrator and step length that keep a scene's error below a bound.</summary>
    /// <param name="scene">Converted by <see cref="StepFree"/>.</param>
    /// <param name="error">The bound on the larger of the angle (rad) and the distance (m) to the true motion, at any time.</param>
    /// <param name="progress">Receives the finished fraction.</param>
    /// <remarks>
    /// For every integrator of the catalogue the longest step for which the error, plus the uncertainty of the truth, is below the bound;
    /// then the times of these. An integrator is dropped where its steps cost far more than the best of the others.
    /// </remarks>
    public static Advice Choose(SceneDescription scene, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Truth truth = Truth.Of(scene, done => progress?.Invoke(0.4 * done), error);
        return Choose(scene, truth, error, done => progress?.Invoke(0.4 + 0.6 * done));
    }

    /// <summary>The same for a known motion.</summary>
    public static Advice Choose(SceneDescription scene, Truth truth, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Guard.NotNull(truth, nameof(truth));
        return Choose(scene, truth, error, Probes.Of([scene], truth.Duration)[0], progress);
    }

    /// <summary>The same with known costs of a step of each integrator, ns.</summary>
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

        // in the order of the catalogue: of equal costs the first is taken
        Trial[] inOrder = [.. Rules.All.SelectMany(rule => below.Where(trial => trial.Rule == rule))];
        return new Advice(truth, new Contest(inOrder, done => progress?.Invoke(0.8 + 0.2 * done)));
    }

    /// <summary>True if a trial is below the bound, including the uncertainty of the truth and the effect of the last bit of the start.</summary>
    internal static bool IsBelow(Trial trial, Truth truth, double error) => trial.Error + Doubt * (truth.Uncertainty + truth.Floor) < error;

    /// <summary>The cheapest of some timed trials; of equal costs, the first.</summary>
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
