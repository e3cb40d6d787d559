namespace RigidBodyDynamics.Lab;

/// <summary>
/// Compares a run with the truth between its steps, at the end of a shorter step from the last one: a motion that oscillates in
/// phase with the steps is right at each of them and wrong between.
/// </summary>
internal static class Halfway
{
    /// <summary>The error between steps may exceed the error at the sampled places by this factor.</summary>
    public const double Between = 1.05;

    // of few steps all are sampled; of many, some, and of very many fewer, because the run itself takes long
    private const int FewSteps = 32, PlacesPerStep = 8, LeastPlaces = 4;
    private const long MostSteps = 100_000;

    // the golden section: no two parts are equal, and no oscillation that fits into a step coincides with all of them
    private const double Golden = 0.6180339887498949;

    /// <summary>Compares until the error of a state exceeds the limit.</summary>
    public static void Compare(SceneDescription scene, Truth truth, Deviation[] found, double most)
    {
        double length = scene.Steps.Length(0);
        Simulation simulation = new Simulation(scene);
        foreach ((long step, double part) in Places(scene.Steps.Count))
        {
            simulation.Step(step - simulation.StepsDone);
            SavedSimulation before = simulation.Save();
            simulation.StepBy(part * length);
            for (int i = 0; i < found.Length; i++)
            {
                Body body = simulation.Bodies[i];
                if (!found[i].Add(body.State, truth.At(i, (step + part) * length), body.Mass, most))
                    return;
            }

            simulation.Restore(before);
        }
    }

    /// <summary>The sampled steps in order, and the part of each.</summary>
    private static IEnumerable<(long Step, double Part)> Places(long count)
    {
        int most = FewSteps * PlacesPerStep;
        int places = count <= FewSteps ? (int)count * PlacesPerStep : (int)Math.Clamp(2 * MostSteps / count, LeastPlaces, most);
        return Enumerable.Range(0, places).Select(i => (count <= FewSteps ? i / PlacesPerStep : (count - 1) * (i + 1) / places, (i + 1) * Golden % 1));
    }
}
