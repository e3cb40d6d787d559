using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>About what a step of each rule costs, before it is known which steps are short enough.</summary>
internal static class Probes
{
    private const int Steps = 100, LeastRounds = 40;
    private const double SecondsPerTurn = 0.0002, LeastSeconds = 0.3;

    /// <summary>For each rule, ns; NaN for one that refuses the scene.</summary>
    /// <remarks>In turns, and for so long that a runtime which compiles again what runs often has done so: else who comes first seems the dearest.</remarks>
    public static IReadOnlyDictionary<Rule, double> Of(SceneDescription scene, double duration)
    {
        Dictionary<Rule, double> least = Rules.All.ToDictionary(rule => rule, _ => double.NaN);
        Dictionary<Rule, TimedRun> runs = [];
        Stopwatch clock = Stopwatch.StartNew();
        for (int round = 0; round < LeastRounds || clock.Elapsed.TotalSeconds < LeastSeconds; round++)
        {
            foreach (Rule rule in Rules.All)
            {
                try
                {
                    if (round == 0)
                        runs[rule] = new TimedRun(StepFree.By(scene, rule, TimeSteps.Every(duration / Steps, Steps)));

                    if (runs.TryGetValue(rule, out TimedRun? run))
                        least[rule] = double.MinNumber(least[rule], run.Nanoseconds(SecondsPerTurn));
                }
                catch (Exception)
                {
                    // a rule may refuse a scene, or run away from it in these steps
                    runs.Remove(rule);
                    least[rule] = double.NaN;
                }
            }
        }

        return least;
    }
}
