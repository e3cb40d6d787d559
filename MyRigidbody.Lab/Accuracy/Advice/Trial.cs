namespace RigidBodyDynamics.Lab;

/// <summary>One rule at one step on one scene: how far it is from the truth, and what it costs.</summary>
public sealed class Trial
{
    private Trial(SceneDescription scene, Rule rule, double step)
    {
        Scene = scene;
        Rule = rule;
        Step = step;
    }

    /// <summary>The rule.</summary>
    public Rule Rule { get; }

    /// <summary>Length of its steps, s.</summary>
    public double Step { get; }

    /// <summary>How many steps there are: as many as it takes to reach the end of the scene, which the last may pass.</summary>
    public long Steps => Scene.Steps.Count;

    /// <summary>
    /// Largest angle to the true orientation over all bodies and steps, and between steps (<see cref="Halfway"/>), rad; at the samples
    /// only where no more is known. Infinite if the run broke off.
    /// </summary>
    public double AngleError { get; private set; }

    /// <summary>Largest distance from the true position, m.</summary>
    public double PositionError { get; private set; }

    /// <summary>Largest deviation of a kinetic energy from the true one, relative to its largest; in J where that is zero.</summary>
    public double EnergyDrift { get; private set; }

    /// <summary>Largest deviation of an angular momentum, as a vector, relative to its largest; in kg m²/s where that is zero.</summary>
    public double MomentumDrift { get; private set; }

    /// <summary>The larger of the angle (rad) and the distance (m).</summary>
    public double Error => Math.Max(AngleError, PositionError);

    /// <summary>True if the run was ended before its end, because an error was above what is allowed: the true one is larger.</summary>
    public bool GaveUp { get; private set; }

    /// <summary>Time for one step of one body, ns; NaN until it is taken by <see cref="StepClock"/>.</summary>
    public double NanosecondsPerStep { get; internal set; } = double.NaN;

    /// <summary>Time for a simulated second of one body, s.</summary>
    public double Cost => 1e-9 * NanosecondsPerStep / Step;

    internal SceneDescription Scene { get; }

    /// <summary>Runs a scene once, as <c>run</c> does, and compares it with the truth at the end of every step and between.</summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="truth">Its motion.</param>
    /// <param name="rule">The rule.</param>
    /// <param name="step">Length of its steps, s.</param>
    /// <param name="most">With an error above it a run is not looked at between its steps.</param>
    /// <param name="toItsEnd">False: nor is it then run to its end.</param>
    public static Trial Of(SceneDescription scene, Truth truth, Rule rule, double step, double most = double.PositiveInfinity, bool toItsEnd = true) =>
        OfStepFree(StepFree.Of(scene), Guard.NotNull(truth, nameof(truth)), Guard.NotNull(rule, nameof(rule)), step, most, toItsEnd);

    /// <summary>The same of a scene that <see cref="StepFree"/> has made.</summary>
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
            // a rule may refuse a scene; that is an answer
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
