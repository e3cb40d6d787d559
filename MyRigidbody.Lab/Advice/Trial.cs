namespace RigidBodyDynamics.Lab;

/// <summary>One rule at one step on one scene: how far it is from the truth, and what it costs.</summary>
public sealed class Trial
{
    private Trial(Scene scene, CatalogueRow row, double step, int parts)
    {
        Scene = scene;
        Row = row;
        Step = step;
        Parts = parts;
    }

    /// <summary>The rule.</summary>
    public CatalogueRow Row { get; }

    /// <summary>Length of its steps, s.</summary>
    public double Step { get; }

    /// <summary>How many of them make a base step of the truth.</summary>
    public int Parts { get; }

    /// <summary>How many steps there are to the last sample.</summary>
    public long Steps => Scene.Steps.Count;

    /// <summary>Largest angle to the true orientation over all samples and bodies, rad; infinite if the run broke off.</summary>
    public double AngleError { get; private set; }

    /// <summary>Largest distance from the true position, m.</summary>
    public double PositionError { get; private set; }

    /// <summary>Largest deviation of a kinetic energy from the true one, relative to its largest; in J where that is zero.</summary>
    public double EnergyDrift { get; private set; }

    /// <summary>Largest deviation of an angular momentum, as a vector, relative to its largest; in kg m²/s where that is zero.</summary>
    public double MomentumDrift { get; private set; }

    /// <summary>The larger of the angle (rad) and the distance (m).</summary>
    public double Error => Math.Max(AngleError, PositionError);

    /// <summary>Time for one step of one body, ns; NaN until it is taken by <see cref="StepClock"/>.</summary>
    public double NanosecondsPerStep { get; internal set; } = double.NaN;

    /// <summary>Time for a simulated second of one body, s.</summary>
    public double Cost => 1e-9 * NanosecondsPerStep / Step;

    internal Scene Scene { get; }

    /// <summary>The run that was compared, and where it stood at <see cref="StepClock.Places"/> times, evenly spread.</summary>
    internal Simulation? Run { get; private set; }

    internal List<SavedSimulation> Places { get; } = new List<SavedSimulation>();

    /// <summary>Runs a scene once and compares it with the truth.</summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="truth">Its motion.</param>
    /// <param name="row">The rule.</param>
    /// <param name="parts">How many steps the truth's base step is divided into.</param>
    public static Trial Of(Scene scene, Truth truth, CatalogueRow row, int parts)
    {
        Guard.NotNull(truth, nameof(truth));
        double step = truth.BaseStep / (parts >= 1 ? parts : throw Guard.Refused(nameof(parts), parts, "must be at least 1"));
        TimeSteps steps = TimeSteps.Every(step, truth.Samples[truth.Samples.Count - 1].At * parts);
        Trial trial = new Trial(StepFree.By(StepFree.Of(scene), Guard.NotNull(row, nameof(row)).Name, steps), row, step, parts);
        try
        {
            trial.Compare(truth, parts);
        }
        catch (Exception)
        {
            // a rule may refuse a scene; that is an answer
            trial.AngleError = double.NaN;
        }

        bool isFinite = Guard.IsFinite(trial.Error + trial.EnergyDrift + trial.MomentumDrift);
        if (!isFinite)
            trial.AngleError = trial.PositionError = trial.EnergyDrift = trial.MomentumDrift = double.PositiveInfinity;

        return trial;
    }

    private void Compare(Truth truth, int parts)
    {
        // what a step does is on trial, so each is taken
        Simulation simulation = Run = new Simulation(Scene, Omissions.All & ~Omissions.Coasting);
        int count = simulation.Bodies.Count;
        double[] energy = new double[count], momentum = new double[count], energyOff = new double[count], momentumOff = new double[count];
        foreach (TruthSample sample in truth.Samples)
        {
            Go(simulation, sample.At * parts);
            for (int i = 0; i < count; i++)
            {
                BodyState found = simulation.Bodies[i].State, right = sample.Bodies[i];
                MassProperties mass = simulation.Bodies[i].Mass;
                AngleError = Larger(AngleError, Conserved.AngleBetween(found.Orientation, right.Orientation));
                PositionError = Larger(PositionError, (found.Position - right.Position).Length);
                double e = Conserved.KineticEnergy(right, mass);
                Vector3d l = Conserved.AngularMomentum(right, mass);
                energy[i] = Larger(energy[i], e);
                momentum[i] = Larger(momentum[i], l.Length);
                energyOff[i] = Larger(energyOff[i], Math.Abs(Conserved.KineticEnergy(found, mass) - e));
                momentumOff[i] = Larger(momentumOff[i], (Conserved.AngularMomentum(found, mass) - l).Length);
            }
        }

        for (int i = 0; i < count; i++)
        {
            EnergyDrift = Larger(EnergyDrift, energyOff[i] / (energy[i] > 0 ? energy[i] : 1));
            MomentumDrift = Larger(MomentumDrift, momentumOff[i] / (momentum[i] > 0 ? momentum[i] : 1));
        }
    }

    private void Go(Simulation simulation, long to)
    {
        while (simulation.StepsDone < to)
        {
            long place = Places.Count < StepClock.Places ? Steps / StepClock.Places * Places.Count : to;
            if (simulation.StepsDone == place)
                Places.Add(simulation.Save());
            else
                simulation.Step(Math.Min(place, to) - simulation.StepsDone);
        }
    }

    /// <summary>Keeps a NaN, which Math.Max does not do on every runtime.</summary>
    private static double Larger(double a, double b) => a >= b ? a : b + 0 * a;
}
