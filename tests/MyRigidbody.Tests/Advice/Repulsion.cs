namespace RigidBodyDynamics.Tests;

/// <summary>A push away from the origin, in proportion to the distance: a body beside the origin moves away as e^(√rate t).</summary>
internal readonly struct Repulsion(double rate) : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        impulse.Force += duration * rate * mass.Mass * body.Position;
}
