namespace RigidBodyDynamics
{
    /// <summary>
    /// Pushes and free motion, one after the other, each by its own exact flow. Between pushes the motion under gravity, constant
    /// forces and damping, and the rotation, are exact; a step composes pushes and such intervals symmetrically. Without pushes the
    /// step is one free motion, exact for any length.
    /// </summary>
    internal partial struct Composition<TTop, TScheme> : IIntegrator
        where TTop : struct, IFreeTop
        where TScheme : struct, IScheme
    {
        private const EffectTraits ReadsMotion = EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

        private TTop _top;
        private Vector3d _x, _xLost, _v, _vLost;
        private MassProperties _mass;
        private bool _canMove, _isOffCenter;
        private double _dt;
        private Coasting _coasting;
        private bool _decaysPerStep;
        private Decay _perStep;
        private Drift _whole;

        public BodyState State
        {
            get
            {
                _top.Show(out Quaterniond orientation, out Vector3d angularVelocity);
                return new BodyState(Origin(orientation), orientation, _v, angularVelocity);
            }
        }

        public bool IsAsleep => false;

        public bool IsFinite => _x.IsFinite && Guard.IsFinite(_v.LengthSquared) && _top.IsFinite;

        public bool HasClosedForm => _top.HasClosedForm && (!_decaysPerStep || (!_canMove && typeof(TTop) == typeof(HeldTop)));

        public void Start(in Beginning body)
        {
            Quaterniondd q = body.Orientation;
            BodyState start = body.Raw;
            _mass = body.Mass;
            _canMove = body.CanMove;
            _isOffCenter = !_mass.CenterOfMass.IsZero;
            _x = _isOffCenter ? start.Position + q.Rotate(_mass.CenterOfMass).Rounded : start.Position;
            _v = start.Velocity;
            _xLost = _vLost = Vector3d.Zero;
            _top = default(TTop);
            _top.Start(_mass, q, body.AngularVelocityInBody);
        }

        public void Push(in Wrench impulse)
        {
            if (_canMove)
                RunningSum.Add(ref _v, ref _vLost, _mass.InverseMass * impulse.Force);

            // without a torque, the prepared constants of the rotation stay valid
            if (!(impulse.Torque.IsZero && impulse.BodyTorque.IsZero))
                _top.Kick(impulse.Torque, impulse.BodyTorque);
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _coasting = coasting;
            _whole = new Drift(coasting, duration);
            _perStep = Decay.To(coasting.AngularFactorPerStep);
            _decaysPerStep = coasting.LinearFactorPerStep != 1 || coasting.AngularFactorPerStep != 1;
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            if ((push.Traits & (EffectTraits.Moves | EffectTraits.Turns)) == 0)
                Free<TPush>();
            else
                Compose(now, ref push);

            if (_decaysPerStep)
            {
                _v = Decay.By(_coasting.LinearFactorPerStep, _v);
                _vLost = Decay.By(_coasting.LinearFactorPerStep, _vLost);
                _top.Damp(_perStep);
            }
        }

        private void Free<TPush>() where TPush : struct, IPush
        {
            if (typeof(TPush) != typeof(Leap))
            {
                Advance(_dt);
                return;
            }

            DoubleDouble time = new DoubleDouble(_dt, _coasting.Rest);
            if (_canMove)
            {
                _whole.Move(ref _x, ref _xLost, ref _v, ref _vLost);
                RunningSum.Add(ref _x, ref _xLost, time.Low * _v);
            }

            _top.Leap(Drift.TurningTimeOf(_coasting.AngularDampingRate, time));
            _top.Damp(_whole.AngularDecay);
        }

        private void Compose<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            TScheme scheme = default(TScheme);
            if (scheme.Mirrored != null && (push.Traits & ReadsMotion) != 0)
            {
                ComposeMirrored(now, scheme.Mirrored, ref push);
                return;
            }

            double[] kicks = scheme.Kicks, drifts = scheme.Drifts;
            Instant at = new Instant(now.Step, now.Time, scheme.HoldsTime);
            for (int i = 0; i < drifts.Length; i++)
            {
                double kick = kicks[i] * _dt, length = drifts[i] * _dt;
                Kick(at, kick, ref push);
                Advance(length);
                at = at.Later(scheme.HoldsTime ? length : kick);
            }

            Kick(at, kicks[drifts.Length] * _dt, ref push);
        }

        private void ComposeMirrored<TPush>(in Instant now, double[] parts, ref TPush push) where TPush : struct, IPush
        {
            Instant at = new Instant(now.Step, now.Time, isHeld: true);
            for (int i = 0; i < parts.Length; i += 2)
            {
                double length = (parts[i] + parts[i + 1]) * _dt;
                Give(at, parts[i] * _dt, ref push);
                Advance(length);
                at = at.Later(length);
                Give(at.Reversed, parts[i + 1] * _dt, ref push);
            }
        }

        private void Advance(double length)
        {
            if (_whole.IsFree)
            {
                RunningSum.Add(ref _x, ref _xLost, length * _v);
                _top.Advance(length);
                return;
            }

            if (length == _dt)
                Advance(_whole);
            else
                Advance(new Drift(_coasting, length));
        }

        private void Advance(in Drift drift)
        {
            if (_canMove)
                drift.Move(ref _x, ref _xLost, ref _v, ref _vLost);

            _top.Advance(drift.TurningTime);
            _top.Damp(drift.AngularDecay);
        }

        private void Kick<TPush>(in Instant now, double duration, ref TPush push) where TPush : struct, IPush
        {
            if ((push.Traits & ReadsMotion) == 0)
            {
                Give(now, duration, ref push);
                return;
            }

            // a push that reads a velocity depends on the pushes before it, not on those after: forwards and backwards, so that the order stays 2
            double half = 0.5 * duration;
            Give(now, half, ref push);
            Give((now.IsHeld ? now : now.Later(half)).Reversed, half, ref push);
        }

        private void Give<TPush>(in Instant now, double duration, ref TPush push) where TPush : struct, IPush
        {
            // the change of ω by other pushes (Wrench.AppliedTo) depends on the orientation
            const EffectTraits ReadsPose = EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation | EffectTraits.ReadsAngularVelocity;
            EffectTraits traits = push.Traits;
            BodyState body = default(BodyState);
            if ((traits & EffectTraits.ReadsVelocity) != 0)
                body.Velocity = _v;

            if ((traits & ReadsPose) != 0)
            {
                body.Orientation = _top.Orientation;
                body.Position = Origin(body.Orientation);
            }

            if ((traits & EffectTraits.ReadsAngularVelocity) != 0)
                body.AngularVelocity = _top.AngularVelocity;

            Wrench impulse = default(Wrench);
            push.Over(now, duration, body, _mass, ref impulse);
            // a push that gives zero leaves the prepared constants valid
            if (_canMove && (traits & EffectTraits.Moves) != 0 && !impulse.Force.IsZero)
                RunningSum.Add(ref _v, ref _vLost, _mass.InverseMass * impulse.Force);

            if ((traits & EffectTraits.Turns) != 0 && !(impulse.Torque.IsZero && impulse.BodyTorque.IsZero))
                _top.Kick(impulse.Torque, impulse.BodyTorque);
        }

        private Vector3d Origin(Quaterniond orientation) => _isOffCenter ? _x - orientation.Rotate(_mass.CenterOfMass) : _x;
    }
}
