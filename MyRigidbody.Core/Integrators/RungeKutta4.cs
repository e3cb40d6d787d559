namespace RigidBodyDynamics
{
    /// <summary>
    /// The classical Runge–Kutta method of order 4, with the angular momentum in world axes: L' = τ, so that without a torque L is
    /// exact and only the orientation is approximated. For pushes that have no exact flow.
    /// </summary>
    internal struct RungeKutta4 : IIntegrator
    {
        private MassProperties _mass;
        private PrincipalAxesOrder _axes;
        private Vector3d _inverseMoments;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt;
        private Coasting _coasting;
        private Vector3d _x, _v, _l;
        private Quaterniond _q;

        public BodyState State
        {
            get
            {
                BodyState state = At(_x, _v, _q, _l);
                Quaterniondd q = new Quaterniondd(_q.W, _q.Vector);
                state.AngularVelocity = q.Rotate(Vector3dd.Scale(_inverseMoments, q.Conjugate.Rotate(_l))).Rounded;
                return state;
            }
        }

        public bool IsAsleep => false;

        public bool IsFinite => State.HasFiniteSquares;

        public bool HasClosedForm => !_canMove && !_canTurn;

        public void Start(in Beginning body)
        {
            BodyState start = body.Raw;
            _mass = body.Mass;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !_mass.CenterOfMass.IsZero;
            _axes = new PrincipalAxesOrder(_mass, 0);
            _inverseMoments = _mass.InversePrincipalMoments;
            Quaterniondd q = body.Orientation;
            _x = _isOffCenter ? start.Position + q.Rotate(_mass.CenterOfMass).Rounded : start.Position;
            _v = start.Velocity;
            q = _axes.FromBody(q);
            _q = q.Rounded;
            _l = q.Rotate(Vector3dd.Scale(_mass.PrincipalMoments, _axes.FromBody(body.AngularVelocityInBody))).Rounded;
        }

        public void Push(in Wrench impulse)
        {
            if (_canMove)
                _v += _mass.InverseMass * impulse.Force;

            if (_canTurn)
                _l += impulse.BodyTorque.IsZero ? impulse.Torque : impulse.Torque + _q.Rotate(_axes.FromBody(impulse.BodyTorque));
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _coasting = coasting;
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            double h = _dt, half = 0.5 * h;
            Instant middle = now.Later(half), end = now.Later(h);
            Vector3d x = _x, v1 = _v, l = _l;
            Quaterniond q = _q;
            RatesAt(now, x, v1, q, l, ref push, out Vector3d a1, out Quaterniond q1, out Vector3d l1);
            Vector3d v2 = v1 + half * a1;
            RatesAt(middle, x + half * v1, v2, q + half * q1, l + half * l1, ref push, out Vector3d a2, out Quaterniond q2, out Vector3d l2);
            Vector3d v3 = v1 + half * a2;
            RatesAt(middle, x + half * v2, v3, q + half * q2, l + half * l2, ref push, out Vector3d a3, out Quaterniond q3, out Vector3d l3);
            Vector3d v4 = v1 + h * a3;
            RatesAt(end, x + h * v3, v4, q + h * q3, l + h * l3, ref push, out Vector3d a4, out Quaterniond q4, out Vector3d l4);

            double sixth = h / 6;
            if (_canMove)
            {
                _x = x + sixth * (v1 + 2 * (v2 + v3) + v4);
                _v = _coasting.LinearFactorPerStep * (v1 + sixth * (a1 + 2 * (a2 + a3) + a4));
            }

            if (_canTurn)
            {
                _q = (q + sixth * (q1 + 2 * (q2 + q3) + q4)).Normalized;
                _l = _coasting.AngularFactorPerStep * (l + sixth * (l1 + 2 * (l2 + l3) + l4));
            }
        }

        private void RatesAt<TPush>(
            in Instant at, in Vector3d x, in Vector3d v, in Quaterniond q, in Vector3d l, ref TPush push,
            out Vector3d acceleration, out Quaterniond turning, out Vector3d torque)
            where TPush : struct, IPush
        {
            const EffectTraits Reads =
                EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation | EffectTraits.ReadsAngularVelocity | EffectTraits.ReadsVelocity;
            // between the stages q is longer than 1; its rotation is v ↦ q* v q / |q|²
            double twice = 2 / q.LengthSquared;
            Vector3d u = q.Vector, t = twice * Vector3d.Cross(u, l);
            Vector3d w = 0.5 * Vector3d.Scale(_inverseMoments, l - q.W * t + Vector3d.Cross(u, t));
            // q [0, ω/2]
            turning = new Quaterniond(-Vector3d.Dot(u, w), q.W * w + Vector3d.Cross(u, w));
            torque = -_coasting.AngularDampingRate * l;
            acceleration = _canMove ? _coasting.Acceleration - _coasting.LinearDampingRate * v : Vector3d.Zero;
            if ((push.Traits & (EffectTraits.Moves | EffectTraits.Turns)) == 0)
                return;

            Wrench load = default(Wrench);
            if ((push.Traits & Reads) != 0)
                push.At(at, At(x, v, q.Normalized, l), _mass, ref load);
            else
                push.At(at, default(BodyState), _mass, ref load);

            if (_canMove)
                acceleration += _mass.InverseMass * load.Force;

            if (!_canTurn)
                return;

            torque += load.Torque;
            if (!load.BodyTorque.IsZero)
            {
                Vector3d b = _axes.FromBody(load.BodyTorque), s = twice * Vector3d.Cross(u, b);
                torque += b + q.W * s + Vector3d.Cross(u, s);
            }
        }

        private BodyState At(Vector3d x, Vector3d v, Quaterniond q, Vector3d l)
        {
            Quaterniond body = _axes.ToBody(q);
            Vector3d w = body.Rotate(_axes.ToBody(Vector3d.Scale(_inverseMoments, q.RotateInverse(l))));
            return new BodyState(_isOffCenter ? x - body.Rotate(_mass.CenterOfMass) : x, body, v, w);
        }
    }
}
