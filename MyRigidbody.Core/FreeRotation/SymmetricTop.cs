namespace RigidBodyDynamics
{
    /// <summary>
    /// Exact free rotation of a body with two equal moments, a wheel or a needle. In the world it rotates about L at the
    /// rate |L|/I₁, in the body about its own axis at (1 − I₃/I₁) w₃; both rates are constant, so q₊ = (rotation about L) q
    /// (rotation about axis 3).
    /// </summary>
    internal partial struct SymmetricTop : IFreeTop
    {
        private PrincipalAxesOrder _axes;
        private double _across, _along, _slip;
        private Quaterniond _q, _qLost, _turn;
        private Vector3d _momentum, _momentumLost;
        private double _w3, _w3Lost, _spinW, _spinZ, _preparedFor;

        public Quaterniond Orientation => _axes.ToBody(_q);

        // L/I₁ and the remainder along the axis: across the axis ω is L/I₁
        public Vector3d AngularVelocity => _axes.ToWorld(1 / _across * _momentum + _q.Rotate(new Vector3d(0, 0, _slip * _w3)));

        public bool IsFinite => _q.IsFinite && Guard.IsFinite((1 / _across * _momentum).LengthSquared + _w3 * _w3);

        public bool HasClosedForm => true;

        public void Show(out Quaterniond orientation, out Vector3d angularVelocity)
        {
            Quaterniondd q = new Quaterniondd(_q, _qLost);
            orientation = _axes.ToBody(q).Rounded;
            Vector3dd along = q.Rotate(new Vector3dd(0, 0, (DoubleDouble)_slip * _w3)), turn = 1 / (DoubleDouble)_across * (Vector3dd)_momentum;
            angularVelocity = _axes.ToWorld((turn + along).Rounded);
        }

        public void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity)
        {
            Vector3d i = mass.PrincipalMoments;
            _axes = new PrincipalAxesOrder(mass, i.X == i.Y ? 0 : i.Y == i.Z ? 1 : 2);
            _across = _axes.Moments.X;
            _along = _axes.Moments.Z;
            _slip = (_across - _along) / _across;
            Quaterniondd q = _axes.FromBody(orientation);
            Vector3dd w = _axes.FromBody(angularVelocity);
            _q = q.Rounded;
            _qLost = q.Lost;
            Vector3dd momentum = q.Rotate(Vector3dd.Scale(new Vector3d(_across, _across, _along), w));
            _w3 = w.Z.High;
            _w3Lost = w.Z.Low;
            _momentum = momentum.Rounded;
            _momentumLost = momentum.Lost;
            _preparedFor = double.NaN;
        }

        public void Kick(in Vector3d world, in Vector3d body)
        {
            // L and w₃ are stored separately: each keeps digits that the other has not
            Vector3d inBody = body.IsZero ? body : _axes.FromBody(body), outside = _axes.FromWorld(world);
            RunningSum.Add(ref _w3, ref _w3Lost, (inBody.Z + (world.IsZero ? 0 : _q.RotateInverse(outside).Z)) / _along);
            RunningSum.Add(ref _momentum, ref _momentumLost, body.IsZero ? outside : outside + _q.Rotate(inBody));
            _preparedFor = double.NaN;
        }

        public void Damp(in Decay decay)
        {
            if (decay.IsNone)
                return;

            decay.Take(ref _w3, ref _w3Lost);
            decay.Take(ref _momentum, ref _momentumLost);
            _preparedFor = double.NaN;
        }

        public void Leap(DoubleDouble time)
        {
            DoubleDouble across = 1 / (DoubleDouble)_across, slip = (_across - (DoubleDouble)_along) * across;
            Quaterniondd q = Quaterniondd.Of(across * new Vector3dd(_momentum, _momentumLost), time) * new Quaterniondd(_q, _qLost);
            q = (q * Quaterniondd.Of(new Vector3dd(0, 0, slip * new DoubleDouble(_w3, _w3Lost)), time)).Normalized;
            _q = q.Rounded;
            _qLost = q.Lost;
        }

        public void Advance(double time)
        {
            if (time != _preparedFor)
            {
                Vector3d rate = (1 / _across) * _momentum;
                _turn = SmallTurn.Of(rate, rate.Length, time);
                Quaterniond spin = SmallTurn.Of(new Vector3d(0, 0, _slip * _w3), System.Math.Abs(_slip * _w3), time);
                _spinW = spin.W;
                _spinZ = spin.Z;
                _preparedFor = time;
            }

            Quaterniond d = _turn * _q, p = _q + d;
            SmallTurn.Add(ref _q, ref _qLost, new Quaterniond(
                d.W + p.W * _spinW - p.Z * _spinZ,
                d.X + p.X * _spinW + p.Y * _spinZ,
                d.Y + p.Y * _spinW - p.X * _spinZ,
                d.Z + p.Z * _spinW + p.W * _spinZ));
        }
    }
}
