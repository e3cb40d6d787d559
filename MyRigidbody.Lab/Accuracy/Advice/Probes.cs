using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>A rough cost of a step of each integrator, before it is known which steps are short enough.</summary>
internal static class Probes
{
    private const int Steps = 100, LeastRounds = 20;
    private const double SecondsPerTurn = 0.0002, LeastSeconds = 0.3;

    /// <summary>For each scene and integrator, ns; NaN where the integrator refuses the scene.</summary>
    /// <remarks>Alternately, and for so long that the runtime has optimised all of them: otherwise the first one appears the most expensive.</remarks>
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
                    // an integrator may refuse a scene, or diverge with these steps
                    runs[i].Remove(rule);
                    least[i][rule] = double.NaN;
                }
            }
        }

        return least;
    }
}
