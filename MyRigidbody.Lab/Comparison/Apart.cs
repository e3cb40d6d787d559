namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>How far two bodies are from each other at one time.</summary>
/// <param name="Time">s.</param>
/// <param name="Distance">Between the two positions, m.</param>
/// <param name="Angle">Of the turn from one orientation to the other, rad, 0 to π: what the eye sees.</param>
/// <param name="Turn">
/// How much further one has turned than the other since the start, rad. The angle comes back to zero after a whole
/// turn; this does not, so it is what is shared out among the rules.
/// </param>
internal readonly record struct Moment(double Time, double Distance, double Angle, double Turn);

/// <summary>How far two bodies are from each other over a whole run.</summary>
internal sealed class Apart
{
    private long _count;
    private double _distance, _turn;

    /// <summary>Mean distance over all steps, m.</summary>
    public double MeanDistance => _distance / _count;

    /// <summary>Mean of how much further one has turned, rad.</summary>
    public double MeanTurn => _turn / _count;

    /// <summary>The largest distance, angle and turn, each whenever it came.</summary>
    public Moment Farthest { get; private set; }

    /// <summary>The last moment.</summary>
    public Moment Last { get; private set; }

    /// <summary>Takes in the moment after a step.</summary>
    public void Add(Moment now)
    {
        _count++;
        _distance += now.Distance;
        _turn += now.Turn;
        Last = now;
        Farthest = new Moment(
            now.Time,
            Math.Max(Farthest.Distance, now.Distance),
            Math.Max(Farthest.Angle, now.Angle),
            Math.Max(Farthest.Turn, now.Turn));
    }

    /// <summary>Runs two bodies side by side.</summary>
    public static Apart Between(BodyDescription a, BodyDescription b, TimeSteps steps)
    {
        SideBySide run = new(steps, a, b);
        Apart apart = new();
        while (run.Step())
        {
            apart.Add(run.Between(0, 1));
        }

        return apart;
    }
}
