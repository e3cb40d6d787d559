namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>The results for one pair.</summary>
/// <param name="Pair">The two bodies.</param>
/// <param name="Course">Both states and their difference, at every time that is kept.</param>
/// <param name="Shares">The shares of the rules in the difference.</param>
/// <param name="FrameRates">With forces applied in Update; empty if no keys act.</param>
internal sealed record Findings(
    Pair Pair,
    IReadOnlyList<Compared> Course,
    RuleShares Shares,
    IReadOnlyList<FrameRate> FrameRates)
{
    private const int MostKept = 4000;

    /// <summary>Computes all of them.</summary>
    public static Findings Of(Pair pair, TimeSteps steps, Action<double> report)
    {
        FrameRate[] rates = FrameRate.Matters(pair.Default, steps)
            ? [.. FrameRate.Shown.Select(rate => FrameRate.Of(pair.Default, steps, rate))]
            : [];
        report(0.4);
        RuleShares shares = RuleShares.Of(pair, steps);
        report(0.9);
        return new Findings(pair, Run(pair, steps), shares, rates);
    }

    private static List<Compared> Run(Pair pair, TimeSteps steps)
    {
        SideBySide run = new(steps, pair.Mine, pair.Default);
        long every = 1 + (steps.Count / MostKept);
        List<Compared> course = [];
        do
        {
            if (run.StepsDone % every == 0 || run.StepsDone == steps.Count)
                course.Add(new Compared(run.StepsDone, run[0], run[1], run.Between(0, 1)));
        }
        while (run.Step());
        return course;
    }
}

/// <summary>Both bodies of a pair at one time.</summary>
internal readonly record struct Compared(long Step, BodyState Mine, BodyState Default, Moment Apart);
