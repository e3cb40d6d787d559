namespace RigidBodyDynamics.Tests;

/// <summary>The lab's steps with L in the place of ω: L = L + Δt τ, and ω = I⁻¹ L whenever it is needed.</summary>
public struct MomentumEuler : IIntegrator
{
    private MassProperties _mass;
    private SymmetricMatrix3 _inverseInertia;
    private Coasting _coasting;
    private double _dt;
    private Vector3d _x, _v, _l;
    private Quaterniond _q;

    // what is kept is the centre of mass; what is asked for is the origin of the body frame
    public BodyState State => new BodyState(_x - _q.Rotate(_mass.CenterOfMass), _q, _v, AngularVelocity(_q, _l));

    public bool IsAsleep => false;

    public bool IsFinite => _x.IsFinite && _v.IsFinite && _l.IsFinite && _q.IsFinite;

    public bool HasClosedForm => false;

    public void Start(BodyDescription body)
    {
        _mass = body.Mass;
        _inverseInertia = body.Mass.Inertia.Inverse;
        _q = body.Start.Orientation.Normalized;
        _x = body.Start.Position + _q.Rotate(_mass.CenterOfMass);
        _v = body.Start.Velocity;
        _l = Conserved.AngularMomentum(body.Start, _mass);
    }

    public void Prepare(double duration, in Coasting coasting)
    {
        _dt = duration;
        _coasting = coasting;
    }

    public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
    {
        Wrench load = default(Wrench);
        push.At(now, State, _mass, ref load);

        _v += _dt * (_mass.InverseMass * load.Force + _coasting.Acceleration);
        _l += _dt * load.TorqueInWorld(_q);
        _x += _dt * _v;
        _q = (_q + new Quaterniond(0, 0.5 * _dt * AngularVelocity(_q, _l)) * _q).Normalized;
        _v = _coasting.LinearDecay(_dt) * _v;
        _l = _coasting.AngularDecay(_dt) * _l;
    }

    private Vector3d AngularVelocity(Quaterniond q, Vector3d l) => q.Rotate(_inverseInertia * q.RotateInverse(l));
}
