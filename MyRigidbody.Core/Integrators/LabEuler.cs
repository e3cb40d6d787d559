namespace RigidBodyDynamics
{
    /// <summary>
    /// The lab's script: five steps, in its order. It has no gyroscopic term, so with three different moments it
    /// keeps ω, not L, and converges to the motion of a real body only where the moments are equal.
    /// </summary>
    internal partial struct LabEuler : IIntegrator
    {
        private BodyState _body;
        private MassProperties _mass;
        private LabSettings _lab;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt, _linearDecay, _angularDecay;
        private Vector3d _gravity;

        public BodyState State => _body;

        public bool IsAsleep => false;

        public bool IsFinite => _body.HasFiniteSquares;

        public bool HasClosedForm => !_canMove && !_canTurn;

        public void Start(in Beginning body)
        {
            _body = body.State;
            _mass = body.Mass;
            _lab = body.Lab;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !body.Mass.CenterOfMass.IsZero;
        }

        public void Push(in Wrench impulse)
        {
            // without LabSettings.Normalise q is longer than the turn it stands for
            BodyState pushed = _body;
            pushed.Orientation = pushed.Orientation.Normalized;
            pushed = impulse.AppliedTo(pushed, _mass);
            if (_canMove)
                _body.Velocity = pushed.Velocity;

            if (_canTurn)
                _body.AngularVelocity = pushed.AngularVelocity;
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _gravity = coasting.Acceleration;
            _linearDecay = coasting.LinearDecay(duration);
            _angularDecay = coasting.AngularDecay(duration);
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush =>
            Step(now, ref push, xFromOldVelocity: false);

        internal void Step<TPush>(in Instant now, ref TPush push, bool xFromOldVelocity) where TPush : struct, IPush
        {
            double dt = _dt;
            Wrench load = default(Wrench);
            push.At(now, _body, _mass, ref load);
            Vector3d x = _body.Position, v = _body.Velocity, w = _body.AngularVelocity, oldV = v;
            Quaterniond q = _body.Orientation, oldQ = q;

            // 1. velocity: v = v + Δt (F / m + g)
            if (_canMove)
                v = v + dt * (load.Force / _mass.Mass + _gravity);

            // 2. angular velocity: ω = ω + Δt I⁻¹ τ with I = R I_ref Rᵀ
            if (_canTurn && (push.Traits & EffectTraits.Turns) != 0)
            {
                Matrix3 R = Matrix3.Of(_lab.UnitRotation ? q.Normalized : q);
                SymmetricMatrix3 I = _mass.Inertia.RotatedBy(R);
                w = w + dt * (I.Inverse * load.TorqueInWorld(q));
            }

            // 3. position: x = x + Δt v
            if (_canMove)
                x = x + dt * (xFromOldVelocity ? oldV : v);

            // 4. orientation: q = q + [0, ½ Δt ω] · q, then back to length 1
            if (_canTurn)
            {
                if (_lab.FirstOrderOrientation)
                    q = q + new Quaterniond(0, 0.5 * dt * w) * q;
                else
                    q = q + SmallTurn.Of(w, w.Length, dt) * q;

                q = _lab.Normalise ? q.Normalized : q;
            }

            // 5. damping: v and ω times 0.98, or what else the scene asks for
            _body.Velocity = Decay.By(_linearDecay, v);
            _body.AngularVelocity = Decay.By(_angularDecay, w);
            _body.Orientation = q;
            // x is the centre of mass; the body's origin turns about it
            _body.Position = _isOffCenter ? x + oldQ.Rotate(_mass.CenterOfMass) - q.Rotate(_mass.CenterOfMass) : x;
        }
    }
}
