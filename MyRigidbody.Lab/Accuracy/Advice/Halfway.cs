namespace RigidBodyDynamics.Lab;

/// <summary>
/// Compares a run with the truth between its steps, where a shorter step from the last one leads: a motion that swings in time with
/// the steps is right at each of them and wrong between.
/// </summary>
internal static class Halfway
{
    /// <summary>An error between steps may be larger by so much than at the places that are looked at.</summary>
    public const double Between = 1.05;

    // where there are few steps each is looked into; of many, some, and of very many fewer, since the run itself takes long
    private const int FewSteps = 32, PlacesPerStep = 8, LeastPlaces = 4;
    private const long MostSteps = 100_000;

    // the golden section: no two parts are alike, and no swing that fits into a step fits into them
    private const double Golden = 0.6180339887498949;

    /// <summary>Compares until a state is further off than it may be.</summary>
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

    /// <summary>Steps in their order, and how much of each.</summary>
    private static IEnumerable<(long Step, double Part)> Places(long count)
    {
        int most = FewSteps * PlacesPerStep;
        int places = count <= FewSteps ? (int)count * PlacesPerStep : (int)Math.Clamp(2 * MostSteps / count, LeastPlaces, most);
        return Enumerable.Range(0, places).Select(i => (count <= FewSteps ? i / PlacesPerStep : (count - 1) * (i + 1) / places, (i + 1) * Golden % 1));
    }
}
