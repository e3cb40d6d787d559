namespace RigidBodyDynamics.Lab;

/// <summary>The times at which effects of a body begin and end: its motion is smooth between them, and no step of the truth crosses one.</summary>
internal sealed class Cuts
{
    // times closer together than this part of the whole count as one
    private const double Same = 1e-9;

    private readonly List<double> _times;

    public Cuts(BodyDescription body, double end)
    {
        _times = [0, end];
        foreach (Effect effect in body.Effects)
        {
            Add(effect.From);
            Add(effect.To);
        }
    }

    /// <summary>From zero to the end, in order.</summary>
    public IReadOnlyList<double> Times => _times;

    private void Add(double time)
    {
        int at = ~_times.BinarySearch(time);
        double apart = Same * _times[^1];
        if (at > 0 && at < _times.Count && time - _times[at - 1] > apart && _times[at] - time > apart)
            _times.Insert(at, time);
    }
}
