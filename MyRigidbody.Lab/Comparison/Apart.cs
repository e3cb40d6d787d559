namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>The difference of two bodies at one time.</summary>
/// <param name="Time">s.</param>
/// <param name="Distance">Between the two positions, m.</param>
/// <param name="Angle">Of the rotation from one orientation to the other, rad, 0 to π.</param>
/// <param name="Turn">
/// The difference of the angles by which the two have turned since the start, rad. The angle between orientations returns to zero after a
/// whole revolution and this does not, so this is what the rules have shares in.
/// </param>
internal readonly record struct Moment(double Time, double Distance, double Angle, double Turn);

/// <summary>The difference of two bodies over a whole run.</summary>
internal sealed class Apart
{
    private long _count;
    private double _distance, _turn;

    /// <summary>Mean distance over all steps, m.</summary>
    public double MeanDistance => _distance / _count;

    /// <summary>Mean of the difference of the turns, rad.</summary>
    public double MeanTurn => _turn / _count;

    /// <summary>The largest distance, angle and turn, each at its own time.</summary>
    public Moment Farthest { get; private set; }

    /// <summary>The difference at the end.</summary>
    public Moment Last { get; private set; }

    /// <summary>Adds the difference after a step.</summary>
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
            apart.Add(run.Between(0, 1));

        return apart;
    }
}
