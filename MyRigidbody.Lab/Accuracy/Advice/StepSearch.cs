namespace RigidBodyDynamics.Lab;

/// <summary>Searches the longest step with which an integrator keeps an error bound.</summary>
/// <remarks>
/// The error is not a monotonic function of the step: a step that coincides with the beginnings of effects, or with an oscillation, is
/// better than its neighbours. So all steps are tried from the longest down, and a run ends where its error exceeds the limit. Where runs
/// are long this would take minutes; there each runs to its end, and steps far too long by the integrator's order are skipped.
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

    /// <summary>True if a shorter step than that of the closest trial had a larger error.</summary>
    public bool RisesAgain { get; private set; }

    /// <summary>True if some of the steps coincide with all times at which effects begin and end, or there are none.</summary>
    public bool MeetsEffects => !_hasEffectsInTime || _aligned.Count > 0;

    /// <summary>The trial with the longest step below the bound; null if there is none.</summary>
    /// <param name="rule">The integrator.</param>
    /// <param name="isTooDear">True for a step so short that its cost is not worth it; the search then ends.</param>
    public Trial? Longest(Rule rule, Func<double, bool> isTooDear)
    {
        // steps that coincide with the effects, and the others: the errors of one kind say nothing of the other
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
            // an error that no longer falls with the step consists of roundings
            kind.Rises = trial.Error >= kind.Error && kind.Error < ManyBits ? kind.Rises + 1 : 0;
            kind.Error = trial.Error;
            // a step that does not coincide with an effect has an error of the size of the step, with any integrator
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

    /// <summary>The conclusions from steps tried for the next one.</summary>
    private sealed class Passed
    {
        public double Below = double.PositiveInfinity, Error = double.PositiveInfinity;
        public int Rises;
    }
}
