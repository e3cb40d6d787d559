using System.Collections.Concurrent;

namespace RigidBodyDynamics.Lab;

/// <summary>Every integrator of the catalogue on one motion, with many step lengths.</summary>
/// <param name="Motion">The motion.</param>
/// <param name="Trials">The trials, integrator by integrator, from the longest step down.</param>
internal sealed record CostFindings(CostMotion Motion, IReadOnlyList<Trial> Trials)
{
    /// <summary>Errors for which the cheapest integrator is named.</summary>
    public static readonly double[] Bounds = [1e-3, 1e-6, 1e-9];

    /// <summary>The divisors of the truth's base step: from 1 s down to 0.1 ms where that is 1 s.</summary>
    internal static readonly int[] Parts = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];

    // of a motion of hours only the longer steps
    private const long MostSteps = 20_000_000;

    /// <summary>Measures the errors of all integrators first, then the times of all.</summary>
    public static CostFindings Of(CostMotion motion, Effort effort, Action<double> report)
    {
        int[] parts = [.. PartsOf(motion.Truth).Take(effort.StepSizes)];
        (Rule Rule, int Part)[] asked = [.. Rules.All.SelectMany(rule => parts.Select(part => (rule, part)))];
        Trial[] trials = new Trial[asked.Length];
        int done = 0;
        // on all cores, the longest first; the times below are taken one by one
        Parallel.ForEach(Partitioner.Create(Enumerable.Range(0, asked.Length).OrderByDescending(i => asked[i].Part), EnumerablePartitionerOptions.NoBuffering), i =>
        {
            trials[i] = Trial.Of(motion.Scene, motion.Truth, asked[i].Rule, motion.Truth.BaseStep / asked[i].Part);
            report(0.5 * Interlocked.Increment(ref done) / asked.Length);
        });
        StepClock.Take(trials, effort.SecondsPerTurn, effort.Turns, done => report(0.5 + (0.5 * done)));
        return new CostFindings(motion, trials);
    }

    /// <summary>The divisors for which a motion is not too long.</summary>
    internal static IEnumerable<int> PartsOf(Truth truth) => Parts.Where(parts => truth.Duration / truth.BaseStep * parts <= MostSteps);

    /// <summary>The trials of an integrator, from the longest step down.</summary>
    public IEnumerable<Trial> Of(Rule rule) => Trials.Where(trial => trial.Rule == rule);

    /// <summary>The trial of an integrator whose step is closest to a fiftieth of a second, as in a game.</summary>
    public Trial InGame(Rule rule) => Of(rule).MinBy(trial => Math.Abs(Math.Log(trial.Step * 50)))!;

    /// <summary>The cost of a step of an integrator, in steps of LabEuler timed alternately.</summary>
    public double TimesLab(Rule rule) =>
        InGame(rule).NanosecondsPerStep / InGame(Rules.LabEuler).NanosecondsPerStep;

    /// <summary>The cheapest trial of an integrator below an error, or null.</summary>
    public Trial? Cheapest(Rule rule, double error) =>
        Of(rule).Where(trial => trial.Error < error).MinBy(trial => trial.Cost);

    /// <summary>The cheapest trial of all below an error, or null; of costs that cannot be separated, the first.</summary>
    public Trial? Cheapest(double error)
    {
        Trial[] below = [.. Trials.Where(trial => trial.Error < error)];
        return below.FirstOrDefault(trial => trial.Cost <= Advisor.SameCost * below.Min(other => other.Cost));
    }
}

/// <summary>The effort of a measurement.</summary>
/// <param name="StepSizes">The number of step lengths.</param>
/// <param name="SecondsPerTurn">The duration of one run of a trial, s.</param>
/// <param name="Turns">The number of rounds, after one that does not count.</param>
internal sealed record Effort(int StepSizes, double SecondsPerTurn, int Turns)
{
    /// <summary>For a published page.</summary>
    public static readonly Effort Whole = new(CostFindings.Parts.Length, 0.003, 15);

    /// <summary>For a first impression.</summary>
    public static readonly Effort Quick = new(11, 0.002, 5);
}
