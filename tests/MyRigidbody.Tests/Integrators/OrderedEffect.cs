namespace RigidBodyDynamics.Tests;

/// <summary>An effect whose order is measured.</summary>
/// <param name="Name">As the page calls it.</param>
/// <param name="GiveTo">Gives it to a body, in steps of a length (s), from a time to another (s).</param>
/// <param name="Push">What is given; null where it is gravity or damping.</param>
internal sealed record OrderedEffect(string Name, Action<BodyDescription, double, double, double> GiveTo, Func<double, IPush>? Push)
{
    // factors for a step of this length; what they are over another time is their power
    public const double DecayStep = 0.125;

    private static readonly Vector3d A = new(0.5, -1, 0.75), B = new(-0.25, 0.5, 1), C = new(0.75, 0.25, -0.5);

    /// <summary>All of the library, and some of a user's own that read everything there is.</summary>
    public static IReadOnlyList<OrderedEffect> All { get; } =
    [
        Coast("gravity", _ => new Gravity(new Vector3d(0.5, -2, 0.25))),
        Coast("linear damping", _ => new LinearDamping(0.4)),
        Coast("angular damping", _ => new AngularDamping(0.3)),
        Coast("decay per step", step => new DecayPerStep(Math.Pow(0.95, step / DecayStep), Math.Pow(0.96, step / DecayStep))),
        Pushing("force", _ => new Force(A)),
        Pushing("key, force", _ => new KeyPush(LabKey.RightArrow)),
        Pushing("key, torque", _ => new KeyPush(LabKey.R)),
        Pushing("torque, world axes", _ => new Torque(2 * A, Vector3d.Zero, Vector3d.Zero, 0, inBody: false)),
        Pushing("torque, body axes", _ => new Torque(-2 * A, Vector3d.Zero, Vector3d.Zero, 0, inBody: true)),
        Pushing("torque that swings, world axes", _ => new Torque(A, B, C, 1.7, inBody: false)),
        Pushing("torque that swings, body axes", _ => new Torque(C, A, B, 2.1, inBody: true)),
        Pushing("forces and torques per step", PerStep),
        Pushing("quadratic drag", _ => new QuadraticDrag(0.8)),
        Pushing("force at a point, world axes", _ => new Force(A, at: C)),
        Pushing("force at a point, body axes", _ => new Force(A, at: C, inBody: true)),
        Pushing("force that swings at a point, body axes", _ => new Force(B, C, A, 1.3, at: C, inBody: true)),
        Pushing("spring at the centre of mass", _ => new Spring(new Vector3d(0.1, -0.2, 0.3), B, 6)),
        Pushing("spring off the centre", _ => new Spring(C, A, 3)),
        Pushing("heavy top", _ => new HeavyTop(B, 2, A)),
        Pushing("wind in gusts (v, t)", _ => new Wind(0.4, C, A)),
        Pushing("drag of the spin (ω)", _ => new MomentumDrag(0.2)),
        Pushing("lift of the spin (v, ω)", _ => new Lift(0.7)),
        Pushing("thruster that pulses (q, t)", _ => new Thruster(A, C)),
        Pushing("moving hook (x, t)", _ => new MovingHook(7)),
    ];

    /// <summary>True for the factor per step, of order 1 by every integrator.</summary>
    public bool IsPerStep => Name == "decay per step";

    /// <summary>The same with the rate that a factor per step stands for: the motion is compared with that.</summary>
    public OrderedEffect[] InRates() => !IsPerStep ? [this] :
    [
        Coast("linear", _ => new LinearDamping(-Math.Log(0.95) / DecayStep)),
        Coast("angular", _ => new AngularDamping(-Math.Log(0.96) / DecayStep)),
    ];

    private static OrderedEffect Coast<T>(string name, Func<double, T> effect) where T : struct, ICoast =>
        new(name, (body, step, from, to) => body.With(effect(step), from, to), null);

    private static OrderedEffect Pushing<T>(string name, Func<double, T> effect) where T : struct, IPush =>
        new(name, (body, step, from, to) => body.With(effect(step), from, to), step => effect(step));

    // four values in a second, each for as many steps as it takes
    private static PerStep PerStep(double step)
    {
        int times = (int)Math.Round(0.25 / step);
        return new PerStep([.. Repeated(A, C, B, -A)], [.. Repeated(B, -C, 2 * A, C)]);

        IEnumerable<Vector3d> Repeated(params Vector3d[] values) => values.SelectMany(value => Enumerable.Repeat(value, times));
    }
}

/// <summary>Torque −c |L| L, which reads ω: where the body is held, L falls to L / (1 + c |L| h).</summary>
internal readonly struct MomentumDrag(double c) : IPush
{
    public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsOrientation | EffectTraits.ReadsAngularVelocity;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
    {
        Vector3d l = Conserved.AngularMomentum(body, mass);
        wrench.Torque -= c * l.Length * l;
    }

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        Vector3d l = Conserved.AngularMomentum(impulse.AppliedTo(body, mass), mass);
        double z = c * l.Length * duration;
        impulse.Torque -= z / (1 + z) * l;
    }
}

/// <summary>
/// Force s ω × v on a ball that spins in air. Over is not the exact rotation of v about ω but Cayley's, of order 2 only; it is
/// reversible, which is enough.
/// </summary>
internal readonly struct Lift(double s) : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        wrench.Force += s * Vector3d.Cross(body.AngularVelocity, body.Velocity);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        BodyState moved = impulse.AppliedTo(body, mass);
        Vector3d t = 0.5 * s * duration * mass.InverseMass * moved.AngularVelocity, v = moved.Velocity;
        Vector3d turned = v + Vector3d.Cross(t, v);
        impulse.Force += 2 * mass.Mass / (1 + t.LengthSquared) * Vector3d.Cross(t, turned);
    }
}

/// <summary>A force fixed in the body beside the centre of mass, that pulses.</summary>
internal readonly struct Thruster(Vector3d force, Vector3d arm) : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsOrientation | EffectTraits.ReadsTime;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        Add(1, 1 + Math.Sin(2 * now.Time), body, ref wrench);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
        Add(duration, now.IsHeld ? 1 + Math.Sin(2 * now.Time) : 1 + Math.Sin(duration) / duration * Math.Sin(2 * now.Time + duration), body, ref impulse);

    private void Add(double duration, double mean, in BodyState body, ref Wrench wrench)
    {
        wrench.Force += duration * mean * body.Orientation.Rotate(force);
        wrench.BodyTorque += duration * mean * Vector3d.Cross(arm, force);
    }
}

/// <summary>A spring from the centre of the body's frame to a hook that swings up and down.</summary>
internal readonly struct MovingHook(double stiffness) : IPush
{
    public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition | EffectTraits.ReadsTime;

    public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
        wrench.Force += stiffness * (new Vector3d(0, Math.Sin(3 * now.Time), 0) - body.Position);

    public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
    {
        double mean = now.IsHeld ? Math.Sin(3 * now.Time) : Math.Sin(1.5 * duration) / (1.5 * duration) * Math.Sin(3 * now.Time + 1.5 * duration);
        impulse.Force += duration * stiffness * (new Vector3d(0, mean, 0) - body.Position);
    }
}
