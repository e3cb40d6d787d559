namespace RigidBodyDynamics.Tests;

/// <summary>The lab's steps with L in the place of ω: L = L + Δt τ, and ω = I⁻¹ L whenever it is needed.</summary>
public struct MomentumEuler : IIntegrator
{
    private MassProperties _mass;
    private SymmetricMatrix3 _inverseInertia;
    private Coasting _coasting;
    private bool _canMove, _canTurn;
    private double _dt;
    private Vector3d _x, _v, _l;
    private Quaterniond _q;

    // the centre of mass is stored; the state is that of the origin of the body frame
    public BodyState State => new BodyState(_x - _q.Rotate(_mass.CenterOfMass), _q, _v, AngularVelocity(_q, _l));

    public bool IsAsleep => false;

    public bool IsFinite => State.HasFiniteSquares;

    public bool HasClosedForm => false;

    public void Start(in Beginning body)
    {
        BodyState start = body.State;
        _mass = body.Mass;
        _canMove = body.CanMove;
        _canTurn = body.CanTurn;
        _inverseInertia = _mass.Inertia.Inverse;
        _q = start.Orientation;
        _x = start.Position + _q.Rotate(_mass.CenterOfMass);
        _v = start.Velocity;
        _l = Conserved.AngularMomentum(start, _mass);
    }

    public void Push(in Wrench impulse)
    {
        if (_canMove)
            _v += _mass.InverseMass * impulse.Force;

        if (_canTurn)
            _l += impulse.TorqueInWorld(_q);
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

        if (_canMove)
        {
            _v += _dt * (_mass.InverseMass * load.Force + _coasting.Acceleration);
            _x += _dt * _v;
            _v = _coasting.LinearDecay(_dt) * _v;
        }

        if (_canTurn)
        {
            _l += _dt * load.TorqueInWorld(_q);
            _q = (_q + new Quaterniond(0, 0.5 * _dt * AngularVelocity(_q, _l)) * _q).Normalized;
            _l = _coasting.AngularDecay(_dt) * _l;
        }
    }

    private Vector3d AngularVelocity(Quaterniond q, Vector3d l) => q.Rotate(_inverseInertia * q.RotateInverse(l));
}
