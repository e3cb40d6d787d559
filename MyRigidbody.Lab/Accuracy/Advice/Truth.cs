namespace RigidBodyDynamics.Lab;

/// <summary>The true motion of a scene's bodies, and its uncertainty: known at any time, or, where it comes from elsewhere, at some times.</summary>
public sealed class Truth
{
    /// <summary>A path is known this factor beyond the end of the scene: a last step may end after it.</summary>
    internal const double Beyond = 1.1;

    // the change below which a refinement has converged: absolute, and relative to the requested error
    private const double Still = 1e-14, StillBesideError = 1e-3, MostSeconds = 1 << 16;

    private readonly (MotionPath Path, double Uncertainty, double Floor)[] _bodies;

    /// <summary>A motion from elsewhere.</summary>
    /// <param name="baseStep">All times are whole multiples of it, s.</param>
    /// <param name="uncertainty">The error of the states themselves, the larger of rad and m.</param>
    /// <param name="samples">At least one, in order of time.</param>
    public Truth(double baseStep, double uncertainty, IReadOnlyList<TruthSample> samples)
    {
        BaseStep = Guard.Positive(baseStep, nameof(baseStep));
        Uncertainty = Guard.NotNegative(uncertainty, nameof(uncertainty));
        Samples = Guard.NotNull(samples, nameof(samples));
        _bodies = [];
        if (samples.Count == 0)
            throw Guard.Refused(nameof(samples), 0, "must be at least one");

        long before = 0;
        foreach (TruthSample sample in samples)
        {
            before = sample.At > before ? sample.At : throw Guard.Refused("at", sample.At, "must be later than the sample before");
            Floor = Math.Max(Floor, sample.Floor);
        }

        Duration = before * baseStep;
    }

    private Truth(double duration, (MotionPath Path, double Uncertainty, double Floor)[] bodies)
    {
        Duration = duration;
        double longest = duration >= 10 ? 1 : duration >= 1 ? 0.1 : 0.1 * duration;
        BaseStep = duration / Math.Ceiling(duration / longest - 1e-6);
        Samples = [];
        _bodies = bodies;
        Uncertainty = bodies.Max(body => body.Uncertainty);
        Floor = bodies.Max(body => body.Floor);
    }

    /// <summary>The longest of the steps with which <c>cost</c> compares integrators; it leads to every sample, s.</summary>
    public double BaseStep { get; }

    /// <summary>The end of the scene, s.</summary>
    public double Duration { get; }

    /// <summary>The error of the states themselves, the larger of rad and m.</summary>
    public double Uncertainty { get; }

    /// <summary>The largest error due to the last bit of the start, the larger of rad and m: no integrator can have a smaller one.</summary>
    public double Floor { get; }

    /// <summary>The only known states, in order of time; none where the motion is known at any time.</summary>
    public IReadOnlyList<TruthSample> Samples { get; }

    /// <summary>
    /// Computes the motion by the integrator of highest order in the catalogue, halving the step length until the result has
    /// converged: at every state, and between them. Time is cut exactly where effects begin and end. If that is slow, by RungeKutta4.
    /// </summary>
    /// <param name="scene">Converted by <see cref="StepFree"/>.</param>
    /// <param name="progress">Receives the finished fraction.</param>
    /// <param name="error">The error to be judged by it, the larger of rad and m: a thousandth of it is accurate enough. 0: as accurate as possible.</param>
    /// <remarks>The uncertainty is the last change; the floor is the change due to the last bits of the start.</remarks>
    public static Truth Of(SceneDescription scene, Action<double>? progress = null, double error = 0)
    {
        SceneDescription free = StepFree.Of(scene);
        double duration = free.Steps.StartOf(free.Steps.Count);
        if (!(duration <= MostSeconds))
            throw Guard.Refused("duration", duration, "must be at most " + MostSeconds + " s to be refined");

        (MotionPath, double, double)[] bodies = new (MotionPath, double, double)[free.Bodies.Count];
        for (int i = 0; i < bodies.Length; i++)
        {
            int before = i;
            bodies[i] = new Refinement(free.Bodies[i], Beyond * duration)
                .Run(Math.Max(Still, StillBesideError * error), done => progress?.Invoke((before + done) / bodies.Length));
        }

        return new Truth(duration, bodies);
    }

    /// <summary>The state of a body, in the order of the scene, at a time up to <see cref="Duration"/> and a little beyond, s; the orientation is of length 1 but for its last bits.</summary>
    public BodyState At(int body, double time)
    {
        if (_bodies.Length > 0)
            return _bodies[body].Path.At(time);

        long at = (long)Math.Round(time / BaseStep);
        return Samples.First(sample => sample.At >= at).Bodies[body];
    }

    /// <summary>The same for one of the bodies.</summary>
    internal Truth Alone(int body) => new Truth(Duration, [_bodies[body]]);

    /// <summary>The ends of the steps at which the motion is known.</summary>
    internal IEnumerable<long> Known(TimeSteps steps) => _bodies.Length > 0
        ? Enumerable.Range(1, checked((int)steps.Count)).Select(step => (long)step)
        : Samples.Select(sample => steps.FirstAt(sample.At * BaseStep));
}

/// <summary>The bodies of a scene at one time.</summary>
public sealed class TruthSample
{
    /// <summary>The states at a time.</summary>
    /// <param name="at">The time, in base steps.</param>
    /// <param name="floor">The smallest error possible there, the larger of rad and m.</param>
    /// <param name="bodies">The states, in the order of the scene.</param>
    public TruthSample(long at, double floor, IReadOnlyList<BodyState> bodies)
    {
        At = at >= 1 ? at : throw Guard.Refused(nameof(at), at, "must be at least 1");
        Floor = Guard.NotNegative(floor, nameof(floor));
        Bodies = Guard.NotNull(bodies, nameof(bodies));
    }

    /// <summary>The time, in base steps.</summary>
    public long At { get; }

    /// <summary>The smallest error possible there, the larger of rad and m.</summary>
    public double Floor { get; }

    /// <summary>The states, in the order of the scene.</summary>
    public IReadOnlyList<BodyState> Bodies { get; }
}
