namespace RigidBodyDynamics.Tests;

/// <summary>Drag against air that blows in gusts: force −k abs(v − u) (v − u), with u = mean + sin(t) gust.</summary>
public readonly struct Wind : IPush
{
    private readonly double _k;
    private readonly Vector3d _mean;
    private readonly Vector3d _gust;

    /// <summary>Wind with the given k, kg/m, and velocities of the air, m/s, world axes.</summary>
    public Wind(double k, Vector3d mean, Vector3d gust)
    {
        _k = k;
        _mean = mean;
        _gust = gust;
    }

    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsTime | EffectTraits.ReadsVelocity | EffectTraits.IsDrag;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
    {
        Vector3d w = body.Velocity - Air(now.Time);
        wrench.Force -= _k * w.Length * w;
    }

    /// <remarks>Where u stands still, m w' = −k abs(w) w has w = w₀ / (1 + z), z = k abs(w₀) h / m.</remarks>
    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        double middle = now.IsHeld ? now.Time : now.Time + 0.5 * duration;
        Vector3d v = body.Velocity + mass.InverseMass * impulse.Force;
        Vector3d w = v - Air(middle);
        double z = _k * w.Length * duration * mass.InverseMass;
        impulse.Force -= mass.Mass * (z / (1 + z)) * w;
    }

    /// <summary>In words, for explain.</summary>
    public override string ToString() => "wind " + _mean + " m/s, gusts " + _gust + " m/s";

    private Vector3d Air(double time) => _mean + Elementary.Sin(time) * _gust;
}
