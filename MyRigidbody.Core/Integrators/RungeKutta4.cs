namespace RigidBodyDynamics
{
    /// <summary>
    /// The classical Runge–Kutta rule of order 4, with the angular momentum held in world axes: L' = τ, so that without
    /// a torque L is exact and only the attitude is approximated. For pushes that cannot be taken apart.
    /// </summary>
    public struct RungeKutta4 : IIntegrator
    {
        private MassProperties _mass;
        private PrincipalAxesOrder _axes;
        private Vector3d _inverseMoments;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt;
        private Coasting _coasting;
        private Vector3d _x, _v, _l;
        private Quaterniond _q;

        public BodyState State => At(_x, _v, _q, _l);

        public bool IsAsleep => false;

        public void Start(BodyDescription body)
        {
            BodyState start = body.Start;
            _mass = body.Mass;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !_mass.CenterOfMass.IsZero;
            _axes = new PrincipalAxesOrder(_mass, 0);
            _inverseMoments = _mass.InversePrincipalMoments;
            Quaterniond q = start.Orientation.Normalized;
            _x = _isOffCenter ? start.Position + q.Rotate(_mass.CenterOfMass) : start.Position;
            _v = start.Velocity;
            _q = _axes.FromBody(q);
            Vector3d w = _axes.FromBody(q.RotateInverse(start.AngularVelocity));
            _l = _q.Rotate(Vector3d.Scale(_mass.PrincipalMoments, w));
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _coasting = coasting;
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            double h = _dt;
            Rates k1 = RatesAt(now, _v, _x, _q, _l, ref push);
            Rates k2 = RatesAfter(0.5 * h, now, k1, ref push);
            Rates k3 = RatesAfter(0.5 * h, now, k2, ref push);
            Rates k4 = RatesAfter(h, now, k3, ref push);
            if (_canMove)
            {
                _x += h / 6 * (k1.X + 2 * (k2.X + k3.X) + k4.X);
                _v += h / 6 * (k1.V + 2 * (k2.V + k3.V) + k4.V);
                _v = _coasting.LinearFactorPerStep * _v;
            }

            if (_canTurn)
            {
                _q = (_q + h / 6 * (k1.Q + 2 * (k2.Q + k3.Q) + k4.Q)).Normalized;
                _l += h / 6 * (k1.L + 2 * (k2.L + k3.L) + k4.L);
                _l = _coasting.AngularFactorPerStep * _l;
            }
        }

        private Rates RatesAfter<TPush>(double t, in Instant now, in Rates k, ref TPush push) where TPush : struct, IPush =>
            RatesAt(now.Later(t), _v + t * k.V, _x + t * k.X, _q + t * k.Q, _l + t * k.L, ref push);

        private Rates RatesAt<TPush>(in Instant at, Vector3d v, Vector3d x, Quaterniond q, Vector3d l, ref TPush push)
            where TPush : struct, IPush
        {
            const PushTraits Reads =
                PushTraits.ReadsPosition | PushTraits.ReadsOrientation | PushTraits.ReadsAngularVelocity | PushTraits.ReadsVelocity;
            // between the stages q is longer than 1; the turn it stands for is that of the unit quaternion
            Quaterniond turn = q.Normalized;
            Vector3d w = Vector3d.Scale(_inverseMoments, turn.RotateInverse(l));
            Wrench load = default(Wrench);
            push.At(at, (push.Traits & Reads) != 0 ? At(x, v, turn, l) : default(BodyState), _mass, ref load);
            return new Rates
            {
                X = v,
                V = _mass.InverseMass * load.Force + _coasting.Acceleration - _coasting.LinearDampingRate * v,
                Q = 0.5 * (q * new Quaterniond(0, w)),
                L = load.TorqueInWorld(_axes.ToBody(turn)) - _coasting.AngularDampingRate * l,
            };
        }

        private BodyState At(Vector3d x, Vector3d v, Quaterniond q, Vector3d l)
        {
            Quaterniond body = _axes.ToBody(q);
            Vector3d w = body.Rotate(_axes.ToBody(Vector3d.Scale(_inverseMoments, q.RotateInverse(l))));
            return new BodyState(_isOffCenter ? x - body.Rotate(_mass.CenterOfMass) : x, body, v, w);
        }

        private struct Rates
        {
            public Vector3d X, V, L;
            public Quaterniond Q;
        }
    }
}
