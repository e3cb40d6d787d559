namespace RigidBodyDynamics.Tests;

/// <summary>An effect whose declaration is false.</summary>
internal readonly struct Declared(IPush push, EffectTraits traits) : IPush
{
    public EffectTraits Traits => traits;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        push.At(now, body, mass, ref wrench);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        push.Over(now, duration, body, mass, ref impulse);
}

/// <summary>A force of time and state; without a flow of its own it gives duration × force.</summary>
internal readonly struct Own(EffectTraits traits, Own.Field force, Own.Flow? flow = null) : IPush
{
    public delegate Vector3d Field(Instant now, BodyState body);

    public delegate Vector3d Flow(Instant now, double duration, BodyState body);

    public EffectTraits Traits => traits;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => wrench.Force += force(now, body);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        impulse.Force += flow == null ? duration * force(now, body) : flow(now, duration, body);
}

/// <summary>Overwrites the wrench instead of adding to it.</summary>
internal readonly struct Overwriting(bool at, bool over) : IPush
{
    private static readonly Vector3d Push = new(0, 3, 0);

    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.HasPotential;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        wrench.Force = at ? Push : wrench.Force + Push;

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        impulse.Force = over ? duration * Push : impulse.Force + duration * Push;
}

/// <summary>Drag that ignores the impulses of other effects.</summary>
internal readonly struct DeafDrag : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsVelocity;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        new QuadraticDrag(0.3).At(now, body, mass, ref wrench);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        Wrench alone = default;
        new QuadraticDrag(0.3).Over(now, duration, body, mass, ref alone);
        impulse.Force += alone.Force;
    }
}

/// <summary>Air drag that uses the velocity with the impulses of other effects, and the angular velocity without them.</summary>
internal readonly struct HalfDeafDrag : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
    {
        new QuadraticDrag(0.3).At(now, body, mass, ref wrench);
        wrench.Torque -= 0.01 * body.AngularVelocity;
    }

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        new QuadraticDrag(0.3).Over(now, duration, body, mass, ref impulse);
        impulse.Torque -= 0.01 * duration * body.AngularVelocity;
    }
}

/// <summary>A torque that lets time pass while it is held.</summary>
internal readonly struct Restless(Torque torque) : IPush
{
    public EffectTraits Traits => torque.Traits;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        torque.At(now, body, mass, ref wrench);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        torque.Over(new Instant(now.Step, now.Time), duration, body, mass, ref impulse);
}

/// <summary>A force that grows with every call.</summary>
internal struct Growing : IPush
{
    private int _asked;

    public readonly EffectTraits Traits => EffectTraits.Moves;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        wrench.Force += new Vector3d(++_asked, 0, 0);

    public readonly void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        impulse.Force += new Vector3d(duration, 0, 0);
}

/// <summary>Torque −c ω on a body of equal moments I: ω falls by e^(−c h/I).</summary>
internal readonly struct SpinDrag(double c, EffectTraits reads) : IPush
{
    public EffectTraits Traits => EffectTraits.Turns | reads;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        wrench.Torque -= c * body.AngularVelocity;

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        double moment = mass.PrincipalMoments.X;
        Vector3d w = body.AngularVelocity + impulse.TorqueInWorld(body.Orientation) / moment;
        impulse.Torque -= moment * (1 - Math.Exp(-c * duration / moment)) * w;
    }
}
