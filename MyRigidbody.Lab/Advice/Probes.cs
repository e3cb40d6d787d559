using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>About what a step of each rule costs, before it is known which steps are short enough.</summary>
internal static class Probes
{
    private const int Steps = 100, LeastRounds = 40;
    private const double SecondsPerTurn = 0.0002, LeastSeconds = 0.3;

    /// <summary>For each row, ns; NaN for one that refuses the scene.</summary>
    /// <remarks>In turns, and for so long that a runtime which compiles again what runs often has done so: else who comes first seems the dearest.</remarks>
    public static IReadOnlyDictionary<CatalogueRow, double> Of(Scene scene, double duration)
    {
        Dictionary<CatalogueRow, double> least = Catalogue.Rows.ToDictionary(row => row, _ => double.NaN);
        Dictionary<CatalogueRow, TimedRun> runs = [];
        Stopwatch clock = Stopwatch.StartNew();
        for (int round = 0; round < LeastRounds || clock.Elapsed.TotalSeconds < LeastSeconds; round++)
        {
            foreach (CatalogueRow row in Catalogue.Rows)
            {
                try
                {
                    if (round == 0)
                        runs[row] = new TimedRun(StepFree.By(scene, row.Name, TimeSteps.Every(duration / Steps, Steps)));

                    if (runs.TryGetValue(row, out TimedRun? run))
                        least[row] = double.MinNumber(least[row], run.Nanoseconds(SecondsPerTurn));
                }
                catch (Exception)
                {
                    // a rule may refuse a scene, or run away from it in these steps
                    runs.Remove(row);
                    least[row] = double.NaN;
                }
            }
        }

        return least;
    }
}
