namespace RigidBodyDynamics
{
    /// <summary>Exact free rotation of a body with three equal moments, a cube or a ball: ω is constant, q rotates about it.</summary>
    internal partial struct SphericalTop : IFreeTop
    {
        private double _inverseMoment;
        private Quaterniond _q, _qLost, _turn;
        private Vector3d _w, _wLost;
        private double _preparedFor;

        public Quaterniond Orientation => _q;

        public Vector3d AngularVelocity => _w;

        public bool IsFinite => _q.IsFinite && Guard.IsFinite(_w.LengthSquared);

        public bool HasClosedForm => true;

        public void Show(out Quaterniond orientation, out Vector3d angularVelocity)
        {
            orientation = _q;
            angularVelocity = _w;
        }

        public void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity)
        {
            _inverseMoment = mass.InversePrincipalMoments.X;
            _q = orientation.Rounded;
            _qLost = orientation.Lost;
            Vector3dd w = orientation.Rotate(angularVelocity);
            _w = w.Rounded;
            _wLost = w.Lost;
            _preparedFor = double.NaN;
        }

        public void Kick(in Vector3d world, in Vector3d body)
        {
            RunningSum.Add(ref _w, ref _wLost, _inverseMoment * (body.IsZero ? world : world + _q.Rotate(body)));
            _preparedFor = double.NaN;
        }

        public void Damp(in Decay decay)
        {
            if (decay.IsNone)
                return;

            decay.Take(ref _w, ref _wLost);
            _preparedFor = double.NaN;
        }

        public void Advance(double time)
        {
            if (time != _preparedFor)
            {
                _turn = SmallTurn.Of(_w, _w.Length, time);
                _preparedFor = time;
            }

            SmallTurn.Add(ref _q, ref _qLost, _turn * _q);
        }

        public void Leap(DoubleDouble time)
        {
            Quaterniondd q = (Quaterniondd.Of(new Vector3dd(_w, _wLost), time) * new Quaterniondd(_q, _qLost)).Normalized;
            _q = q.Rounded;
            _qLost = q.Lost;
        }
    }
}
