namespace RigidBodyDynamics.Lab;

/// <summary>How the bodies of a scene really move: their states at some times, and how exactly those can be had.</summary>
public sealed class Truth
{
    /// <summary>A motion that is known from elsewhere.</summary>
    /// <param name="baseStep">All times are whole multiples of it, s.</param>
    /// <param name="uncertainty">The error of the states themselves, the larger of rad and m.</param>
    /// <param name="samples">At least one, in the order of time.</param>
    public Truth(double baseStep, double uncertainty, IReadOnlyList<TruthSample> samples)
    {
        BaseStep = Guard.Positive(baseStep, nameof(baseStep));
        Uncertainty = Guard.NotNegative(uncertainty, nameof(uncertainty));
        Samples = Guard.NotNull(samples, nameof(samples));
        if (samples.Count == 0)
            throw Guard.Refused(nameof(samples), 0, "must be at least one");

        long before = 0;
        foreach (TruthSample sample in samples)
        {
            before = sample.At > before ? sample.At : throw Guard.Refused("at", sample.At, "must be later than the sample before");
            Floor = Math.Max(Floor, sample.Floor);
        }
    }

    /// <summary>The longest step that leads to every sample, s.</summary>
    public double BaseStep { get; }

    /// <summary>The error of the states themselves, the larger of rad and m.</summary>
    public double Uncertainty { get; }

    /// <summary>The largest error that the last bit of the start makes, the larger of rad and m: no rule can be held to less.</summary>
    public double Floor { get; }

    /// <summary>The states, in the order of time.</summary>
    public IReadOnlyList<TruthSample> Samples { get; }

    /// <summary>
    /// Computes the motion by the rule of highest order in the catalogue, in steps of half the length again and
    /// again, until the answer stands still. Time is cut exactly where effects begin and end.
    /// </summary>
    /// <param name="scene">Taken as <see cref="StepFree"/> makes it.</param>
    /// <param name="progress">Told the fraction that is done.</param>
    /// <remarks>The uncertainty is the last change; the floor, what a start moved by its last bits changes.</remarks>
    public static Truth Of(Scene scene, Action<double>? progress = null) => new Refinement(StepFree.Of(scene)).Run(progress ?? (done => { }));
}

/// <summary>The bodies of a scene at one time.</summary>
public sealed class TruthSample
{
    /// <summary>The states at a time.</summary>
    /// <param name="at">The time, in base steps.</param>
    /// <param name="floor">The error that can be attained there, the larger of rad and m.</param>
    /// <param name="bodies">The states, in the order of the scene.</param>
    public TruthSample(long at, double floor, IReadOnlyList<BodyState> bodies)
    {
        At = at >= 1 ? at : throw Guard.Refused(nameof(at), at, "must be at least 1");
        Floor = Guard.NotNegative(floor, nameof(floor));
        Bodies = Guard.NotNull(bodies, nameof(bodies));
    }

    /// <summary>The time, in base steps.</summary>
    public long At { get; }

    /// <summary>The error that can be attained there, the larger of rad and m.</summary>
    public double Floor { get; }

    /// <summary>The states, in the order of the scene.</summary>
    public IReadOnlyList<BodyState> Bodies { get; }
}
