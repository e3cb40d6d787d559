namespace RigidBodyDynamics.Lab;

/// <summary>The times at which a scene is looked at, and at which its effects begin and end: no step goes across one.</summary>
internal sealed class Cuts
{
    private const double Same = 1e-6;
    private const int Samples = 20, MostBaseSteps = 1 << 16;

    private readonly List<double> _times = new List<double>();

    public Cuts(Scene scene)
    {
        double duration = scene.Steps.StartOf(scene.Steps.Count);
        // so that there are ten samples or more
        double longest = duration >= 10 ? 1 : duration >= 1 ? 0.1 : 0.1 * duration;
        double count = Math.Ceiling(duration / longest - Same);
        BaseStep = duration / count;
        if (!(count <= MostBaseSteps))
            throw Guard.Refused("duration", duration, "must be at most " + MostBaseSteps + " s to be refined");

        for (int n = 0; n <= count; n++)
            _times.Add(n * BaseStep);

        At = new long[(int)Math.Min(count, Samples)];
        for (int i = 0; i < At.Length; i++)
            At[i] = (long)count * (i + 1) / At.Length;

        foreach (BodyDescription body in scene.Bodies)
        {
            foreach (Effect effect in body.Effects)
            {
                Add(effect.From);
                Add(effect.To);
            }
        }
    }

    public double BaseStep { get; }

    /// <summary>The times of the samples, in base steps.</summary>
    public long[] At { get; }

    /// <summary>Between the cuts.</summary>
    public int Count => _times.Count - 1;

    /// <summary>So many steps between two cuts.</summary>
    public TimeSteps Divided(int parts)
    {
        double[] lengths = new double[parts * Count];
        for (int i = 0; i < lengths.Length; i++)
            lengths[i] = (_times[i / parts + 1] - _times[i / parts]) / parts;

        return TimeSteps.Of(lengths);
    }

    /// <summary>How many such steps lead to a sample.</summary>
    public long StepsTo(int sample, int parts) => (long)_times.BinarySearch(At[sample] * BaseStep) * parts;

    private void Add(double time)
    {
        int at = ~_times.BinarySearch(time);
        if (at > 0 && at <= Count && time - _times[at - 1] > Same * BaseStep && _times[at] - time > Same * BaseStep)
            _times.Insert(at, time);
    }
}
