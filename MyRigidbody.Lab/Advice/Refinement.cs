namespace RigidBodyDynamics.Lab;

/// <summary>Runs a scene in shorter and shorter steps.</summary>
internal sealed class Refinement
{
    private const double Still = 1e-14, NearlyStill = 1e-9, LastBit = 1.0 / (1L << 52);
    private const long MostSteps = 1L << 20;

    private readonly Scene _scene;
    private readonly Cuts _cuts;

    public Refinement(Scene scene)
    {
        _scene = scene;
        _cuts = new Cuts(scene);
    }

    public Truth Run(Action<double> progress)
    {
        string integrator = HighestOrder();
        BodyState[][] last = Run(integrator, 1, 0), best = last;
        int bestParts = 1;
        double uncertainty = double.PositiveInfinity;
        for (int parts = 2; parts * _cuts.Count <= MostSteps && uncertainty > Still; parts *= 2)
        {
            BodyState[][] next = Run(integrator, parts, 0);
            double change = Apart(last, next)[_cuts.At.Length - 1];
            progress(parts * (double)_cuts.Count / MostSteps);
            last = next;
            if (change < uncertainty)
            {
                best = next;
                bestParts = parts;
                uncertainty = change;
            }
            else if (uncertainty < NearlyStill)
            {
                // a small change that grows again is made of roundings
                break;
            }
        }

        if (!Guard.IsFinite(uncertainty))
            throw Guard.Refused("scene", _scene.Name, "must have a motion without infinite numbers");

        double[] floor = Apart(best, Run(integrator, bestParts, LastBit));
        TruthSample[] samples = new TruthSample[_cuts.At.Length];
        for (int i = 0; i < samples.Length; i++)
            samples[i] = new TruthSample(_cuts.At[i], Math.Min(floor[i], double.MaxValue), best[i]);

        return new Truth(_cuts.BaseStep, uncertainty, samples);
    }

    private static string HighestOrder()
    {
        CatalogueRow highest = Catalogue.Rows[0];
        foreach (CatalogueRow row in Catalogue.Rows)
        {
            // Unity's rule has limits of its own
            if (row.Order >= highest.Order && row.Name != "UnityRigidbody")
                highest = row;
        }

        return highest.Name;
    }

    /// <summary>The states at all samples, with so many steps between two cuts, from a start that is moved by a part of itself.</summary>
    private BodyState[][] Run(string integrator, int parts, double nudge)
    {
        Scene scene = StepFree.By(_scene, integrator, _cuts.Divided(parts));
        foreach (BodyDescription body in scene.Bodies)
        {
            BodyState s = body.Start;
            body.Start = new BodyState(
                Nudged(s.Position, nudge),
                new Quaterniond(s.Orientation.W * (1 + nudge), Nudged(s.Orientation.Vector, -nudge)),
                Nudged(s.Velocity, nudge),
                Nudged(s.AngularVelocity, nudge));
        }

        Simulation simulation = new Simulation(scene);
        BodyState[][] states = new BodyState[_cuts.At.Length][];
        for (int i = 0; i < states.Length; i++)
        {
            simulation.Step(_cuts.StepsTo(i, parts) - simulation.StepsDone);
            states[i] = new BodyState[simulation.Bodies.Count];
            for (int j = 0; j < states[i].Length; j++)
                states[i][j] = simulation.Bodies[j].State;
        }

        return states;
    }

    private static Vector3d Nudged(Vector3d v, double e) => new Vector3d(v.X * (1 + e), v.Y * (1 - e), v.Z * (1 + e));

    /// <summary>How far two runs have been apart up to each sample, and at least the last bit of what is compared.</summary>
    private static double[] Apart(BodyState[][] a, BodyState[][] b)
    {
        double[] apart = new double[a.Length];
        double largest = 0;
        for (int i = 0; i < apart.Length; i++)
        {
            for (int j = 0; j < a[i].Length; j++)
            {
                double angle = Conserved.AngleBetween(a[i][j].Orientation, b[i][j].Orientation);
                double distance = (a[i][j].Position - b[i][j].Position).Length;
                double least = 0.5 * LastBit * Math.Max(1, a[i][j].Position.Length);
                largest = angle + distance < double.PositiveInfinity
                    ? Math.Max(Math.Max(largest, least), Math.Max(angle, distance))
                    : double.PositiveInfinity;
            }

            apart[i] = largest;
        }

        return apart;
    }
}
