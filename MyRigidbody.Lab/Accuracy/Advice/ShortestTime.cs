namespace RigidBodyDynamics.Lab;

/// <summary>The shortest of several times of one thing: what else runs on the machine only adds to a time.</summary>
internal sealed class ShortestTime
{
    // a time that comes back so often, within the clock's doubt, is that of the thing and not of a lucky moment
    private const int Enough = 5;
    private const double Same = 1.01;

    private int _agreeing;

    /// <summary>In the unit of what was added; NaN before anything was.</summary>
    public double Value { get; private set; } = double.NaN;

    /// <summary>True if a further time is not needed: the shortest has come back often enough, or the thing cannot be done.</summary>
    public bool IsKnown => _agreeing >= Enough || double.IsPositiveInfinity(Value);

    /// <summary>One more time; infinite of what cannot be done.</summary>
    public void Add(double time)
    {
        // a time far below those before leaves none that agrees with it
        _agreeing = Value <= Same * time ? _agreeing + (time <= Same * Value ? 1 : 0) : 1;
        Value = double.MinNumber(Value, time);
    }
}
