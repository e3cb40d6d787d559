using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>About what a step of each rule costs, before it is known which steps are short enough.</summary>
internal static class Probes
{
    private const int Steps = 100, LeastRounds = 20;
    private const double SecondsPerTurn = 0.0002, LeastSeconds = 0.3;

    /// <summary>For each scene and rule, ns; NaN where the rule refuses the scene.</summary>
    /// <remarks>In turns, and for so long that a runtime which compiles again what runs often has done so: else who comes first seems the dearest.</remarks>
    public static IReadOnlyList<IReadOnlyDictionary<Rule, double>> Of(IReadOnlyList<SceneDescription> scenes, double duration)
    {
        Dictionary<Rule, double>[] least = [.. scenes.Select(_ => Rules.All.ToDictionary(rule => rule, _ => double.NaN))];
        Dictionary<Rule, TimedRun>[] runs = [.. scenes.Select(_ => new Dictionary<Rule, TimedRun>())];
        Stopwatch clock = Stopwatch.StartNew();
        for (int round = 0; round < LeastRounds || clock.Elapsed.TotalSeconds < LeastSeconds; round++)
        {
            foreach ((int i, Rule rule) in scenes.SelectMany((_, i) => Rules.All.Select(rule => (i, rule))))
            {
                try
                {
                    if (round == 0)
                        runs[i][rule] = new TimedRun(StepFree.By(scenes[i], rule, TimeSteps.Every(duration / Steps, Steps)));

                    if (runs[i].TryGetValue(rule, out TimedRun? run))
                        least[i][rule] = double.MinNumber(least[i][rule], run.Nanoseconds(SecondsPerTurn));
                }
                catch (Exception)
                {
                    // a rule may refuse a scene, or run away from it in these steps
                    runs[i].Remove(rule);
                    least[i][rule] = double.NaN;
                }
            }
        }

        return least;
    }
}
