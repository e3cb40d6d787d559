namespace RigidBodyDynamics
{
    /// <summary>
    /// DefaultRigidbody: the motion of Unity's Rigidbody without contacts. PhysX's method, to the last bit in single precision;
    /// no gyroscopic term unless requested, so a free body keeps ω, whatever its shape.
    /// </summary>
    internal struct UnityRigidbody<R> : IIntegrator where R : struct, IRounding
    {
        private const string Fits = "must fit the precision of UnityRigidbody";

        private RealVector<R> _c, _v, _w, _centerOfMass, _inverseMasses, _inverseMoments, _moments, _gravity;
        private RealQuaternion<R> _q, _frame;
        private Real<R> _inverseMass, _h, _keepV, _keepW, _maxW2, _decayV, _decayW;
        private WakeCounter<R> _wake;
        private MassProperties _mass;
        private UnitySettings _unity;
        private Locks _lock;
        private bool _canMove, _canTurn, _decays;

        public BodyState State
        {
            get
            {
                RealVector<R> origin = _c + _q.Rotate(_frame.RotateInverse(-_centerOfMass));
                Quaterniond orientation = (_q * _frame.Conjugate).ToDouble();
                return new BodyState(origin.ToDouble(), orientation, _v.ToDouble(), _w.ToDouble());
            }
        }

        public bool IsAsleep { get; private set; }

        public bool IsFinite => State.HasFiniteSquares;

        /// <summary>A sleeping body stays where it is, gravity or not, until a force wakes it.</summary>
        public bool HasClosedForm => IsAsleep;

        /// <summary>Seconds until a body at rest falls asleep.</summary>
        public float WakeCounter => _wake.Left;

        public void Start(in Beginning body)
        {
            BodyState start = body.Raw;
            _mass = body.Mass;
            _unity = body.Unity.Copy();
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _inverseMass = 1.0 / (Real<R>)_mass.Mass;
            if ((double)_inverseMass == 0 || !Guard.IsFinite((double)_inverseMass))
                throw Guard.Refused("mass", _mass.Mass, Fits);

            // these may over- or underflow: without a torque they are not used
            _inverseMoments = RealVector<R>.From(_mass.PrincipalMoments).Inverse();
            _moments = _inverseMoments.Inverse();
            // a locked axis has an infinite mass or moment; a velocity that a script sets along it is zero in the next step
            _lock = body.Lock;
            _inverseMoments = RealVector<R>.From(_lock.Turning(_inverseMoments.ToDouble()));
            _inverseMasses = RealVector<R>.From(_lock.Moving((double)_inverseMass * new Vector3d(1, 1, 1)));
            _centerOfMass = Fitting(_mass.CenterOfMass, "centerOfMass");
            _frame = Unit(_mass.PrincipalFrame, "frame");
            RealQuaternion<R> orientation = Unit(start.Orientation, "orientation");
            _c = Fitting(start.Position, "position") + orientation.Rotate(_centerOfMass);
            _q = orientation * _frame;
            _v = Fitting(_lock.Moving(start.Velocity), "velocity");
            _w = Fitting(start.AngularVelocity, "angularVelocity");
            _wake = new WakeCounter<R>(_unity.WakeCounter, _unity.SleepThreshold);
            IsAsleep = false;
        }

        /// <remarks>PhysX's addForce and addTorque in impulse mode: an impulse that is not zero also wakes the body.</remarks>
        public void Push(in Wrench impulse)
        {
            RealVector<R> force = RealVector<R>.From(impulse.Force);
            RealVector<R> torque = RealVector<R>.From(impulse.BodyTorque.IsZero ? impulse.Torque : impulse.TorqueInWorld(State.Orientation));
            if (force.IsZero && torque.IsZero)
                return;

            _wake.Wake();
            IsAsleep = false;
            if (_canMove)
                _v = _v + force.Scale(_inverseMasses);

            if (_canTurn && !torque.IsZero)
                _w = _w + _q.TransformDiagonal(_inverseMoments, torque);
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _h = duration;
            _gravity = RealVector<R>.From(_lock.Moving(coasting.Acceleration));
            _keepV = (1.0 - (Real<R>)_unity.Drag * _h).AtLeast(0.0);
            _keepW = (1.0 - (Real<R>)_unity.AngularDrag * _h).AtLeast(0.0);
            Real<R> maxW = _unity.MaxAngularVelocity;
            _maxW2 = maxW * maxW;
            _decayV = coasting.LinearDecay(duration);
            _decayW = coasting.AngularDecay(duration);
            _decays = (double)_decayV != 1 || (double)_decayW != 1;
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            // 1. accelerations; a force or torque that is not zero wakes the body
            Wrench load = default(Wrench);
            BodyState seen = State;
            push.At(now, seen, _mass, ref load);
            RealVector<R> force = RealVector<R>.From(load.Force);
            RealVector<R> torque = RealVector<R>.From(load.TorqueInWorld(seen.Orientation));
            RealVector<R> a = force.Scale(_inverseMasses);
            RealVector<R> alpha = torque.IsZero ? torque : _q.TransformDiagonal(_inverseMoments, torque);
            if (!(force.IsZero && torque.IsZero))
                _wake.Wake();

            // 2. asleep: the pose stays, gravity or not
            IsAsleep = _wake.Sleeps();
            if (IsAsleep)
            {
                _v = _w = default(RealVector<R>);
                return;
            }

            // 3. to 8. velocities and position
            if (_canMove)
            {
                _v = (_v + a * _h + _gravity * _h) * _keepV;
                _c = _c + _v * _h;
            }

            // 3. to 9. angular velocity and orientation
            if (_canTurn)
            {
                _w = (_w + alpha * _h) * _keepW;
                Limit();
                if (_unity.GyroscopicForces)
                    Gyroscopic();

                Turn();
            }

            if (_decays)
            {
                _v = _v * _decayV;
                _w = _w * _decayW;
            }

            // 10., 11. the counter that puts the body to sleep
            _wake.Run((double)_h, _v, _q.RotateInverse(_w), _inverseMass, _moments);
        }

        /// <summary>A value finite in double may be infinite in single precision, and zero times infinity is NaN.</summary>
        private static RealVector<R> Fitting(Vector3d given, string name)
        {
            RealVector<R> value = RealVector<R>.From(given);
            return value.ToDouble().IsFinite ? value : throw Guard.Refused(name, given, Fits);
        }

        private static RealQuaternion<R> Unit(Quaterniond given, string name)
        {
            RealQuaternion<R> unit = RealQuaternion<R>.From(given).Normalized;
            double square = unit.ToDouble().LengthSquared;
            return square > 0.5 && square < 2 ? unit : throw Guard.Refused(name, given, Fits);
        }

        /// <summary>6. The length of ω is limited, not each component.</summary>
        private void Limit()
        {
            Real<R> w2 = _w.LengthSquared;
            if (w2 > _maxW2)
                _w = _w * (_maxW2 / w2).Sqrt();
        }

        /// <summary>7. One explicit step of L' = −l × L in principal axes, scaled back to the length of L.</summary>
        private void Gyroscopic()
        {
            RealVector<R> l = _q.RotateInverse(_w);
            RealVector<R> momentum = _moments.Scale(l);
            RealVector<R> next = momentum - l.Cross(momentum) * _h;
            Real<R> length = next.LengthSquared.Sqrt();
            if (length.IsZero)
                return;

            next = next * (momentum.LengthSquared.Sqrt() / length);
            _w = _w + _q.Rotate(_inverseMoments.Scale(next) - l);
        }

        /// <summary>9. The exact rotation about ω, which is constant in the world.</summary>
        private void Turn()
        {
            if (_unity.FirstOrderOrientation)
            {
                RealVector<R> half = _w * (0.5 * _h);
                _q = (_q + new RealQuaternion<R>(half.X, half.Y, half.Z, 0.0) * _q).Normalized;
                return;
            }

            Real<R> w2 = _w.LengthSquared;
            if (w2.IsZero)
                return;

            Real<R> s = w2.Sqrt();
            (_h * s * 0.5).SinCos(out Real<R> sin, out Real<R> cos);
            RealVector<R> axis = _w * (sin / s);
            _q = (new RealQuaternion<R>(axis.X, axis.Y, axis.Z, 0.0) * _q + _q.Times(cos)).Normalized;
        }
    }
}
