namespace RigidBodyDynamics.Lab;

/// <summary>Looks for the longest step in which a rule keeps an error.</summary>
/// <remarks>
/// An error does not fall evenly with the step: one that meets the beginnings of effects, or a swing, is better than its neighbours. So
/// all steps are tried from the longest down, and a run ends where it is too far off. Where runs are long this would take minutes; there
/// each is run to its end, and what is far too long by the rule's order is passed over.
/// </remarks>
internal sealed class StepSearch
{
    private const long LongRun = 2000, VeryLongRun = 20_000;
    private const double Coarse = 1.1, Fine = 1.02, Beside = 1.25, ManyBits = 1e-9;

    private readonly SceneDescription _free;
    private readonly Truth _truth;
    private readonly double _error;
    private readonly double[] _steps;
    private readonly HashSet<double> _aligned;
    private readonly bool _hasEffectsInTime;

    public StepSearch(SceneDescription scene, Truth truth, double error)
    {
        _free = StepFree.Of(scene);
        _truth = truth;
        _error = error;
        _steps = StepSizes.Of(scene, truth.Duration);
        _aligned = [.. StepSizes.Aligned(scene, truth.Duration)];
        _hasEffectsInTime = StepSizes.Cuts(scene, truth.Duration).Length > 0;
    }

    /// <summary>The trial with the smallest error of those that ran to their end; null before there is one.</summary>
    public Trial? Closest { get; private set; }

    /// <summary>True if a shorter step than that of the closest was further off.</summary>
    public bool RisesAgain { get; private set; }

    /// <summary>True if some of the steps meet all times at which effects begin and end, or there are none.</summary>
    public bool MeetsEffects => !_hasEffectsInTime || _aligned.Count > 0;

    /// <summary>The trial in the longest step that keeps the error; null if there is none.</summary>
    /// <param name="rule">The rule.</param>
    /// <param name="isTooDear">True for a step that is too short to be worth it; the search then ends.</param>
    public Trial? Longest(Rule rule, Func<double, bool> isTooDear)
    {
        // those that meet the effects, and the others, whose errors say nothing of each other
        Passed met = new(), missed = new();
        foreach (double step in _steps)
        {
            bool misses = _hasEffectsInTime && !_aligned.Contains(step);
            Passed kind = misses ? missed : met;
            if (step > kind.Below || kind.Rises > 1)
                continue;

            if (isTooDear(step))
                break;

            long count = StepSizes.Count(_truth.Duration, step);
            Trial trial = Trial.OfStepFree(_free, _truth, rule, step, _error, toItsEnd: count > (misses ? VeryLongRun : LongRun));
            if (Advisor.IsBelow(trial, _truth, _error))
                return trial;

            if (count > LongRun)
                kind.Below = step / (count > VeryLongRun ? Coarse : misses ? Fine : 1);

            if (trial.GaveUp)
                continue;

            Note(trial);
            // what no longer falls with the step is made of roundings
            kind.Rises = trial.Error >= kind.Error && kind.Error < ManyBits ? kind.Rises + 1 : 0;
            kind.Error = trial.Error;
            // what misses an effect is off by the size of the step, whatever the rule
            if (count > LongRun && Guard.IsFinite(trial.Error))
                kind.Below = Math.Min(kind.Below, step * Beside * Math.Pow(_error / trial.Error, misses ? 1 : 1.0 / rule.Order));
        }

        return null;
    }

    private void Note(Trial trial)
    {
        bool isClosest = Closest is null || trial.Error < Closest.Error;
        RisesAgain = !isClosest && (RisesAgain || trial.Rule == Closest!.Rule);
        Closest = isClosest ? trial : Closest;
    }

    /// <summary>What the steps that were tried say of the next.</summary>
    private sealed class Passed
    {
        public double Below = double.PositiveInfinity, Error = double.PositiveInfinity;
        public int Rises;
    }
}
