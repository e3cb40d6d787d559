using System.Diagnostics;

namespace RigidBodyDynamics.Lab;

/// <summary>Runs a scene again and again from the same steps, taking every step, and gives the cost of a step.</summary>
internal sealed class TimedRun
{
    /// <summary>A run that is too long to be timed as a whole is timed in pieces from this many steps on: effects may act for a part of it only.</summary>
    internal const int MostPlaces = 16;

    /// <summary>So many steps take long compared with reading the clock.</summary>
    internal const long Piece = 250;

    private const int MostSimulations = 250;

    // the runs of one place are timed together
    private readonly List<(Simulation Simulation, SavedSimulation Place)[]> _batches = [];
    private readonly long _piece;

    public TimedRun(SceneDescription scene, long piece = Piece)
    {
        long count = scene.Steps.Count;
        if (count <= MostPlaces * piece)
        {
            _piece = count;
            _batches.Add([.. Enumerable.Range(0, (int)Math.Clamp(piece / count, 1, MostSimulations)).Select(_ => Of(scene)).Select(one => (one, one.Save()))]);
            return;
        }

        _piece = piece;
        Simulation run = Of(scene);
        for (int i = 0; i < MostPlaces; i++)
        {
            run.Step(count / MostPlaces * i - run.StepsDone);
            _batches.Add([(run, run.Save())]);
        }
    }

    /// <summary>The steps from which it is timed.</summary>
    internal IEnumerable<long> Places => _batches.Select(batch => batch[0].Place.StepsDone);

    /// <summary>For a step of a body, ns, measured within some seconds.</summary>
    public double Nanoseconds(double seconds)
    {
        Stopwatch clock = new Stopwatch();
        long done = 0;
        while (clock.Elapsed.TotalSeconds < seconds)
        {
            // either all places or none, so that each has the same weight
            foreach ((Simulation Simulation, SavedSimulation Place)[] batch in _batches)
            {
                foreach ((Simulation simulation, SavedSimulation place) in batch)
                    simulation.Restore(place);

                clock.Start();
                foreach ((Simulation simulation, _) in batch)
                    simulation.Step(_piece);

                clock.Stop();
                done += _piece * batch.Length;
            }
        }

        return 1e9 * clock.Elapsed.TotalSeconds / ((double)done * _batches[0][0].Simulation.Bodies.Count);
    }

    private static Simulation Of(SceneDescription scene) => new Simulation(scene, Omissions.All & ~Omissions.Coasting);
}
