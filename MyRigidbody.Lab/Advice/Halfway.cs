namespace RigidBodyDynamics.Lab;

/// <summary>
/// Compares a run with the truth between its steps, where a shorter step from the last one leads: a motion that swings in time with
/// the steps is right at each of them and wrong between.
/// </summary>
internal static class Halfway
{
    // where there are few steps each is looked into; of many, some, and as many as may be run up to
    private const int FewSteps = 12, MostPlaces = 24, LeastPlaces = 4;
    private const long MostSteps = 100_000;
    private static readonly double[] Parts = [0.5, 0.25, 0.75];

    /// <summary>False if a state is further off than it may be.</summary>
    public static bool Compare(Scene scene, Truth truth, Deviation[] found, double most)
    {
        foreach ((long step, double part) in Places(scene.Steps.Count))
        {
            double length = scene.Steps.Length(0);
            TimeSteps steps = TimeSteps.Of([.. Enumerable.Repeat(length, (int)step), part * length]);
            Simulation simulation = new Simulation(new Scene(scene.Name, string.Empty, steps, scene.Bodies));
            simulation.Step(steps.Count);
            for (int i = 0; i < found.Length; i++)
            {
                Body body = simulation.Bodies[i];
                if (!found[i].Add(body.State, truth.At(i, (step + part) * length), body.Mass, most))
                    return false;
            }
        }

        return true;
    }

    /// <summary>Steps, and how much of each.</summary>
    private static IEnumerable<(long Step, double Part)> Places(long count)
    {
        if (count <= FewSteps)
            return Enumerable.Range(0, (int)count).SelectMany(step => Parts.Select(part => ((long)step, part)));

        int places = (int)Math.Clamp(MostSteps / count, LeastPlaces, MostPlaces);
        return Enumerable.Range(1, places).Select(i => ((count - 1) * i / places, Parts[i % Parts.Length]));
    }
}
