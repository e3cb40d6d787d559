using System.Globalization;

namespace RigidBodyDynamics.Fuzz;

/// <summary>The results of many inputs.</summary>
internal sealed class Tally
{
    private readonly int[] _outcomes = new int[Enum.GetValues<Outcome>().Length];
    private TimeSpan _slowest;
    private string _slowestName = "none", _largestName = "none";
    private double _largest;

    /// <summary>The number of inputs.</summary>
    public int Inputs => _outcomes.Sum();

    /// <summary>The number of inputs with this result.</summary>
    public int this[Outcome outcome] => _outcomes[(int)outcome];

    /// <summary>Counts an input.</summary>
    public void Add(string name, Outcome outcome, double times, TimeSpan time)
    {
        _outcomes[(int)outcome]++;
        if (times > _largest)
            (_largest, _largestName) = (times, name);

        if (time > _slowest)
            (_slowest, _slowestName) = (time, name);
    }

    /// <inheritdoc/>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture,
        $"{Inputs} inputs: {Inputs - this[Outcome.Refused]} accepted ({this[Outcome.RanAway]} of them ran away in five steps), {this[Outcome.Refused]} refused; at most {_largest:0.0} times the file and {Reading.Base >> 10} KiB allocated ({_largestName}); slowest {_slowest.TotalMilliseconds:0} ms ({_slowestName})");
}
