using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Every rule of the catalogue on one motion, as thoroughly as a reader waits for it: from long steps to shorter ones, until a time is over.</summary>
internal static class CostInTime
{
    /// <summary>The longest step in which every rule is tried, however long it takes: that of a game, s.</summary>
    internal const double Game = 0.02;

    // what the errors may take of the time, and one of the runs that find them
    private const double ForErrors = 0.6, ForOneRun = 0.08;

    // so close to what can be had a shorter step only rounds more often
    private const double NearFloor = 10, LastBits = 1e-10;

    /// <summary>Takes the errors first, then the times, in turns; both end in time, but for what a game's step takes.</summary>
    /// <param name="motion">The motion.</param>
    /// <param name="seconds">How long it may take, s.</param>
    /// <param name="report">Told the fraction that is done.</param>
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
        // how long the last run of a rule took, for those that go on
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
