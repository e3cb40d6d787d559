using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Every integrator of the catalogue on one motion, within a time that a reader waits: from long steps to shorter ones.</summary>
internal static class CostInTime
{
    /// <summary>The longest step with which every integrator is tried, however long it takes: that of a game, s.</summary>
    internal const double Game = 0.02;

    // the part of the time for all errors, and for one run
    private const double ForErrors = 0.6, ForOneRun = 0.08;

    // this close to the smallest error possible, a shorter step only adds roundings
    private const double NearFloor = 10, LastBits = 1e-10;

    /// <summary>Measures the errors first, then the times, alternately; both end in time, except for the step of a game.</summary>
    /// <param name="motion">The motion.</param>
    /// <param name="seconds">The time allowed, s.</param>
    /// <param name="report">Receives the finished fraction.</param>
    public static CostFindings Of(CostMotion motion, double seconds, Action<double> report)
    {
        Stopwatch clock = Stopwatch.StartNew();
        List<Trial> trials = Errors(motion, seconds, done => report(ForErrors * done));
        double left = Math.Max((1 - ForErrors) * seconds, seconds - clock.Elapsed.TotalSeconds);
        StepClock.TakeWithin(trials, left, done => report(ForErrors + ((1 - ForErrors) * done)));
        return new CostFindings(motion, [.. Rules.All.SelectMany(rule => trials.Where(trial => trial.Rule == rule))]);
    }

    private static List<Trial> Errors(CostMotion motion, double seconds, Action<double> report)
    {
        Stopwatch all = Stopwatch.StartNew(), one = new();
        Truth truth = motion.Truth;
        double floor = Math.Min(LastBits, NearFloor * Math.Max(truth.Floor, truth.Uncertainty));
        // the duration of the last run of each integrator that continues
        Dictionary<Rule, double> took = Rules.All.ToDictionary(rule => rule, _ => 0.0);
        List<Trial> trials = [];
        int before = 1;
        foreach (int parts in CostFindings.PartsOf(truth))
        {
            double step = truth.BaseStep / parts;
            bool isGame = step > Game / 1.5;
            foreach (Rule rule in took.Keys.ToArray())
            {
                double expected = took[rule] * parts / before;
                if (!isGame && (expected > ForOneRun * seconds || all.Elapsed.TotalSeconds + expected > ForErrors * seconds))
                {
                    took.Remove(rule);
                    continue;
                }

                one.Restart();
                Trial trial = Trial.Of(motion.Scene, truth, rule, step);
                took[rule] = one.Elapsed.TotalSeconds;
                trials.Add(trial);
                if (!isGame && trial.Error < floor)
                    took.Remove(rule);

                report(Math.Min(1, all.Elapsed.TotalSeconds / (ForErrors * seconds)));
            }

            before = parts;
        }

        return trials;
    }
}
