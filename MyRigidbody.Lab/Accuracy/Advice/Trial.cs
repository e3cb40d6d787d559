namespace RigidBodyDynamics.Lab;

/// <summary>One integrator with one step length on one scene: its error and its cost.</summary>
public sealed class Trial
{
    private Trial(SceneDescription scene, Rule rule, double step)
    {
        Scene = scene;
        Rule = rule;
        Step = step;
    }

    /// <summary>The integrator.</summary>
    public Rule Rule { get; }

    /// <summary>The step length, s.</summary>
    public double Step { get; }

    /// <summary>The number of steps: as many as reach the end of the scene, which the last may pass.</summary>
    public long Steps => Scene.Steps.Count;

    /// <summary>
    /// Largest angle to the true orientation over all bodies and steps, and between steps (<see cref="Halfway"/>), rad; only at the
    /// samples where the truth has no other times. Infinite if the run broke off.
    /// </summary>
    public double AngleError { get; private set; }

    /// <summary>Largest distance from the true position, m.</summary>
    public double PositionError { get; private set; }

    /// <summary>Largest error of a kinetic energy, relative to its largest value; in J where that is zero.</summary>
    public double EnergyDrift { get; private set; }

    /// <summary>Largest error of an angular momentum, as a vector, relative to its largest value; in kg m²/s where that is zero.</summary>
    public double MomentumDrift { get; private set; }

    /// <summary>The larger of the angle (rad) and the distance (m).</summary>
    public double Error => Math.Max(AngleError, PositionError);

    /// <summary>True if the run was ended early because its error exceeded the limit: the whole run has a larger error.</summary>
    public bool GaveUp { get; private set; }

    /// <summary>Time for one step of one body, ns; NaN until <see cref="StepClock"/> has measured it.</summary>
    public double NanosecondsPerStep { get; internal set; } = double.NaN;

    /// <summary>Time for a simulated second of one body, s.</summary>
    public double Cost => 1e-9 * NanosecondsPerStep / Step;

    internal SceneDescription Scene { get; }

    /// <summary>Runs a scene once, as <c>run</c> does, and compares it with the truth at the end of every step and between steps.</summary>
    /// <param name="scene">Converted by <see cref="StepFree"/>.</param>
    /// <param name="truth">Its motion.</param>
    /// <param name="rule">The integrator.</param>
    /// <param name="step">The step length, s.</param>
    /// <param name="most">Above this error a run is not compared between its steps.</param>
    /// <param name="toItsEnd">False: above it the run is not continued to its end either.</param>
    public static Trial Of(SceneDescription scene, Truth truth, Rule rule, double step, double most = double.PositiveInfinity, bool toItsEnd = true) =>
        OfStepFree(StepFree.Of(scene), Guard.NotNull(truth, nameof(truth)), Guard.NotNull(rule, nameof(rule)), step, most, toItsEnd);

    /// <summary>The same for a scene converted by <see cref="StepFree"/>.</summary>
    internal static Trial OfStepFree(SceneDescription scene, Truth truth, Rule rule, double step, double most, bool toItsEnd)
    {
        TimeSteps steps = TimeSteps.Until(truth.Duration, step);
        Trial trial = new Trial(StepFree.By(scene, rule, steps), rule, step);
        try
        {
            Deviation[] found = [.. trial.Scene.Bodies.Select(body => new Deviation())], halfway = [.. found.Select(_ => new Deviation())];
            trial.Compare(truth, found, toItsEnd ? double.PositiveInfinity : most);
            bool isKept = found.All(body => body.Largest <= most);
            if (isKept && truth.Samples.Count == 0)
                Halfway.Compare(trial.Scene, truth, halfway, most);

            trial.GaveUp = !isKept && !toItsEnd;
            trial.AngleError = Math.Max(found.Max(body => body.Angle), Halfway.Between * halfway.Max(body => body.Angle));
            trial.PositionError = Math.Max(found.Max(body => body.Distance), Halfway.Between * halfway.Max(body => body.Distance));
            trial.EnergyDrift = found.Max(body => body.Energy);
            trial.MomentumDrift = found.Max(body => body.Momentum);
        }
        catch (Exception)
        {
            // an integrator may refuse a scene; that is a result
            trial.AngleError = double.NaN;
        }

        bool isFinite = Guard.IsFinite(trial.Error + trial.EnergyDrift + trial.MomentumDrift);
        if (!isFinite)
            trial.AngleError = trial.PositionError = trial.EnergyDrift = trial.MomentumDrift = double.PositiveInfinity;

        return trial;
    }

    private void Compare(Truth truth, Deviation[] found, double most)
    {
        Simulation simulation = new Simulation(Scene);
        foreach (long step in truth.Known(Scene.Steps))
        {
            simulation.Step(step - simulation.StepsDone);
            for (int i = 0; i < found.Length; i++)
            {
                Body body = simulation.Bodies[i];
                if (!found[i].Add(body.State, truth.At(i, simulation.Time), body.Mass, most))
                    return;
            }
        }
    }
}
