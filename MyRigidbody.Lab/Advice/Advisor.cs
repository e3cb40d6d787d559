using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds out by trying, at load time, by which rule and in which steps a scene should run.</summary>
public static class Advisor
{
    /// <summary>Costs that differ by no more than this factor are the same to the clock; the row that stands first is then taken.</summary>
    public const double SameCost = 1.03;

    private const double SecondsPerTurn = 0.005, ManyBits = 1e-9;
    private const int Turns = 10;
    private const long MostSteps = 20_000_000;

    /// <summary>How many steps the truth's base step is divided into: from 1 s down to 0.1 ms where that is 1 s.</summary>
    public static IReadOnlyList<int> Parts { get; } = new[] { 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000 };

    /// <summary>The cheapest rule and step that keep a scene's error below a bound.</summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="error">The bound on the larger of the angle (rad) and the distance (m) to the true motion, at any time.</param>
    /// <param name="progress">Told the fraction that is done.</param>
    /// <remarks>
    /// For every row of the catalogue: from the longest step down until the error, and what the truth itself is
    /// uncertain by, is below the bound; then the time of those.
    /// </remarks>
    public static Advice Choose(Scene scene, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Truth truth = Truth.Of(scene, done => progress?.Invoke(0.4 * done), error);
        return Choose(scene, truth, error, done => progress?.Invoke(0.4 + 0.6 * done));
    }

    /// <summary>The same where the motion is known already.</summary>
    public static Advice Choose(Scene scene, Truth truth, double error, Action<double>? progress = null)
    {
        Guard.Positive(error, nameof(error));
        Guard.NotNull(truth, nameof(truth));
        List<Trial> below = new List<Trial>();
        Trial? closest = null;
        bool risesAgain = false;
        for (int i = 0; i < Catalogue.Rows.Count; i++)
        {
            bool isBelow = false;
            foreach (int parts in Parts)
            {
                if (isBelow || truth.Duration / truth.BaseStep * parts > MostSteps)
                    break;

                Trial trial = Trial.Of(scene, truth, Catalogue.Rows[i], truth.BaseStep / parts);
                isBelow = IsBelow(trial, truth, error);
                if (isBelow)
                    below.Add(trial);

                bool isClosest = closest is null || trial.Error < closest.Error;
                risesAgain = !isClosest && (risesAgain || trial.Row == closest!.Row);
                closest = isClosest ? trial : closest;
            }

            progress?.Invoke(0.8 * (i + 1) / Catalogue.Rows.Count);
        }

        if (below.Count == 0)
            return new Advice(truth, closest!, null, Why(truth, closest!, error, risesAgain));

        StepClock.Take(below, SecondsPerTurn, Turns, done => progress?.Invoke(0.8 + 0.2 * done));
        Trial best = FirstOfCheapest(below);
        below.Remove(best);
        return new Advice(truth, best, Cheapest(below), string.Empty);
    }

    /// <summary>True if a trial keeps the bound, whatever the truth is uncertain by and the last bit of the start changes.</summary>
    internal static bool IsBelow(Trial trial, Truth truth, double error) => trial.Error + truth.Uncertainty + truth.Floor < error;

    /// <summary>The cheapest of some trials whose time was taken; of those that cost the same, the one that stands first.</summary>
    internal static Trial FirstOfCheapest(List<Trial> trials) => trials.First(trial => trial.Cost <= SameCost * Cheapest(trials)!.Cost);

    private static Trial? Cheapest(List<Trial> trials) => trials.MinBy(trial => trial.Cost);

    private static string Why(Truth truth, Trial closest, double error, bool risesAgain)
    {
        if (truth.Floor >= error && truth.Floor > ManyBits)
            return Words("chaos: the last bit of the start alone moves the answer by {0:0.0e+0}", truth.Floor);

        if (truth.Floor >= error || risesAgain)
            return Words("rounding floor, about {0:0.0e+0}: below it the last bits decide, and shorter steps only round more often", truth.Floor);

        return truth.Uncertainty >= error
            ? Words("the reference: the motion itself could only be found to {0:0.0e+0}", truth.Uncertainty)
            : Words("the step: {0:R} s is the shortest that was tried, and still too long", closest.Step);
    }

    private static string Words(string format, double value) => string.Format(CultureInfo.InvariantCulture, format, value);
}
