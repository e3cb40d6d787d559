using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Exact free rotation of a body with three different moments: one rational map per step, with
    /// constants that hold as long as nothing turns the body. No trigonometry, no iteration.
    /// </summary>
    /// <remarks>
    /// The body turns by the smallest rotation that takes M₊ = I w₊ to M, then about L by ψ (<see cref="OrbitStep"/>).
    /// Constants fit one orbit only, and a rounding takes w off it; what the map then does grows exponentially. So
    /// each step also sets w back to its energy and its Q, by amounts of the size of a rounding.
    /// Rounding errors of q and w are carried along (Kahan), for slow bodies the larger part of the error.
    /// </remarks>
    internal partial struct AsymmetricTop : IFreeTop
    {
        // carried invariants this far from those of w are the remains of a body brought to rest
        internal const double SameInvariant = 1e-12;
        // w and q must not underflow when squared twice
        internal const double Resting = 1e-150;
        // the square of an angle so small that 1e18 of them are nothing
        internal const double NoTurn = 1e-72;
        // near the unstable axis one step over many flips loses the small components
        internal const double LongestNearUnstable = 15;
        // where so many parts are not enough no digit of the input is left to be saved
        private const long MostParts = 1000;
        // (sine of) the largest angle at which a correction may be made at the wrong end of a step
        internal const double ShortSquared = 0.25 * 0.25;
        internal const double Tiny = 1e-290;
        // damping is taken into w before pushes over it, raised to the sixth power, overflow
        internal const double LeastScale = 1e-20;

        private TopShape _shape;
        private Vector3d _w, _wLost;
        private Quaterniond _q, _qLost;
        private double _energy, _separation, _scale;
        private OrbitStep _orbit;
        private double _preparedFor, _inverseEnergy;
        private long _count;
        private bool _isShort;

        public Quaterniond Orientation => _shape.Axes.ToBody(_q);

        public Vector3d AngularVelocity => _shape.Axes.ToWorld(_q.Rotate(_scale * _w));

        public bool IsFinite => Guard.IsFinite(_q.LengthSquared + _w.LengthSquared);

        /// <summary>Near the unstable axis a long turn is many short ones.</summary>
        public bool HasClosedForm => !IsNearUnstableAxis(Math.Max(_shape.AlphaOfA3 * A3, _shape.BetaOfA1 * A1));

        private double A1 => _shape.I1 * _w.X * _w.X + _shape.G1 * _w.Y * _w.Y;

        private double A3 => _shape.I3 * _w.Z * _w.Z + _shape.G3 * _w.Y * _w.Y;

        public void Show(out Quaterniond orientation, out Vector3d angularVelocity)
        {
            Quaterniondd q = new Quaterniondd(_q, _qLost);
            orientation = _shape.Axes.ToBody(q).Rounded;
            angularVelocity = _shape.Axes.ToWorld(q.Rotate(_scale * new Vector3dd(_w, _wLost)).Rounded);
        }

        public void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity) =>
            Start(mass.Shape, orientation, angularVelocity);

        internal void Start(TopShape shape, in Quaterniondd orientation, in Vector3dd angularVelocity)
        {
            _shape = shape;
            Quaterniondd q = _shape.Axes.FromBody(orientation);
            Vector3dd w = _shape.Axes.FromBody(angularVelocity);
            _q = q.Rounded;
            _qLost = q.Lost;
            _w = w.Rounded;
            _wLost = w.Lost;
            _scale = 1;
            _preparedFor = double.NaN;
            Invariants(out _energy, out _separation);
        }

        public void Kick(in Vector3d world, in Vector3d body)
        {
            Vector3d j = world.IsZero ? Vector3d.Zero : _q.RotateInverse(_shape.Axes.FromWorld(world));
            j = body.IsZero ? j : j + _shape.Axes.FromBody(body);
            // w is ω before damping took all but _scale of it; taken into w at every push, one rounded factor would add up
            j = _scale == 1 ? j : 1 / _scale * j;
            TopShape s = _shape;
            double d1 = s.InverseMoments.X * j.X, d2 = s.InverseMoments.Y * j.Y, d3 = s.InverseMoments.Z * j.Z;
            // the exact change of w changes energy and Q; taken from the rounded w they would lose what they are held for
            double e1 = (2 * _w.X + d1) * d1, e2 = (2 * _w.Y + d2) * d2, e3 = (2 * _w.Z + d3) * d3;
            _energy += s.I1 * e1 + e2 + s.I3 * e3;
            _separation += s.M1 * e1 - s.M3 * e3;
            Change(d1, d2, d3);
            _preparedFor = double.NaN;
        }

        public void Damp(in Decay decay)
        {
            if (decay.IsNone)
                return;

            // L' = L × ω − c L is free rotation of M = L e^(ct) in the time s, s' = e^(−ct): w itself is left alone
            _scale = decay.Of(_scale);
            if (_scale < LeastScale)
                Fold();
        }

        public void Advance(double time)
        {
            time *= _scale;
            if (time != _preparedFor)
                Prepare(time);

            for (long i = 0; i < _count; i++)
                Turn();
        }

        public void Leap(DoubleDouble time)
        {
            if (!HasClosedForm)
            {
                Advance(time.High);
                return;
            }

            time = _scale * time;
            if (!(_energy > Resting && _energy * time.High * time.High > NoTurn))
                return;

            Quaterniondd q = new Quaterniondd(_q, _qLost);
            Vector3dd w = new Vector3dd(_w, _wLost);
            _shape.Long.Advance(ref q, ref w, time);
            _q = q.Rounded;
            _qLost = q.Lost;
            _w = w.Rounded;
            _wLost = w.Lost;
        }

        private void Prepare(double time)
        {
            Invariants(out double energy, out double separation);
            TopShape s = _shape;
            double a1 = A1, a3 = A3;
            if (!(Math.Abs(_energy - energy) <= SameInvariant * energy))
                _energy = energy;

            if (!(Math.Abs(_separation - separation) <= SameInvariant * (s.G3 * a1 + s.G1 * a3)))
                _separation = separation;

            _preparedFor = time;
            _count = _energy > Resting && _energy * time * time > NoTurn ? 1 : 0;
            if (_count == 0)
                return;

            double q = _separation;
            double alpha = s.AlphaOfA3 * a3, beta = s.BetaOfA1 * a1, rate = Math.Max(alpha, beta);
            if (IsNearUnstableAxis(rate) && rate * time * time > LongestNearUnstable * LongestNearUnstable)
                _count = (long)Math.Ceiling(Math.Min(MostParts, Math.Sqrt(rate) * Math.Abs(time) / LongestNearUnstable));

            _inverseEnergy = 0.5 / _energy;
            _orbit.Set(s, a1, a3, q, time / _count);
            while (_orbit.IsIllConditioned && _count < MostParts)
                _orbit.Set(s, a1, a3, q, time / ++_count);

            _isShort = rate * _orbit.S * _orbit.S <= ShortSquared && _orbit.C1 > 0 && _orbit.C3 > 0;
        }

        private bool IsNearUnstableAxis(double rate) => Math.Abs(_shape.DeltaOfQ * _separation) < 0.01 * rate;

        private void Turn()
        {
            TopShape s = _shape;
            double w1 = _w.X, w2 = _w.Y, w3 = _w.Z, o = _orbit.S;

            // w₊ by Jacobi's addition theorem; for ordinary steps its increment, so that small changes keep their digits
            double d1, d2, d3, p1 = w1, p2 = w2, p3 = w3;
            if (_isShort)
            {
                double k = s.K1 * s.K3 * o * o * w2 * w2, inverse = 1 / (1 - k);
                d1 = (w1 * (k - _orbit.V1) + s.K1 * o * _orbit.C3 * w2 * w3) * inverse;
                d2 = (w2 * (k - (_orbit.V1 + _orbit.V3 - _orbit.V1 * _orbit.V3)) + s.K2 * o * w3 * w1) * inverse;
                d3 = (w3 * (k - _orbit.V3) + s.K3 * o * _orbit.C1 * w1 * w2) * inverse;
            }
            else
            {
                // D as a sum of positive terms: 1 − k cancels near the unstable axis
                double inverse = 1 / (_orbit.C1 * _orbit.C1 - s.K1 * s.K2 * o * o * w3 * w3);
                p1 = (w1 * _orbit.C1 + s.K1 * o * _orbit.C3 * w2 * w3) * inverse;
                p2 = (w2 * _orbit.C1 * _orbit.C3 + s.K2 * o * w3 * w1) * inverse;
                p3 = (w3 * _orbit.C3 + s.K3 * o * _orbit.C1 * w1 * w2) * inverse;
                d1 = p1 - w1;
                d2 = p2 - w2;
                d3 = p3 - w3;
            }

            // back to the energy by scaling (a), to Q along its gradient at right angles to that (b); in a short step by
            // what is wrong at its start, so that the two divisions need not wait for those above
            double a = _inverseEnergy * (s.I1 * p1 * p1 + p2 * p2 + s.I3 * p3 * p3) - 0.5;
            double x1 = s.M1 * p1 * p1, x3 = s.M3 * p3 * p3, x = x1 - x3, lambda = 2 * _inverseEnergy * x;
            double b = (x - 2 * a * x - _separation) / (2 * (s.G3 * x1 + s.G1 * x3) + Tiny);
            d1 -= p1 * (a + b * (s.G3 - lambda));
            d2 -= p2 * (a - b * lambda);
            d3 -= p3 * (a - b * (s.G1 + lambda));
            Change(d1, d2, d3);

            // r ~ (C |M + M₊|²/2, C (M₊ × M) + Z (M + M₊)), with M₊ × M = (M₊ − M) × M
            double m1 = s.I1 * w1, m2 = w2, m3 = s.I3 * w3, c1 = s.I1 * d1, c2 = d2, c3 = s.I3 * d3;
            double s1 = 2 * m1 + c1, s2 = 2 * m2 + c2, s3 = 2 * m3 + c3;
            double r0 = 0.5 * _orbit.C * (s1 * s1 + s2 * s2 + s3 * s3);
            double r1 = _orbit.C * (c2 * m3 - c3 * m2) + _orbit.Z * s1;
            double r2 = _orbit.C * (c3 * m1 - c1 * m3) + _orbit.Z * s2;
            double r3 = _orbit.C * (c1 * m2 - c2 * m1) + _orbit.Z * s3;
            double vv = r1 * r1 + r2 * r2 + r3 * r3, n = Math.Sqrt(r0 * r0 + vv);
            // by more than half a turn −r is nearer to 1 than r: it is taken, and the sign made up for, so that q does not jump
            n = r0 < 0 ? -n : n;
            double f = 1 / (n * (n + r0)), v = f * (n + r0);
            Vector3d momentum = _isShort ? Vector3d.Zero : _q.Rotate(new Vector3d(m1, m2, m3));
            SmallTurn.Add(ref _q, ref _qLost, _q * new Quaterniond(-vv * f, v * r1, v * r2, v * r3));
            if (r0 < 0)
            {
                _q = -1 * _q;
                _qLost = -1 * _qLost;
            }

            if (!_isShort)
                KeepDirection(momentum);
        }

        /// <summary>
        /// Where M₊ points almost back along M, as after a flip, the smallest rotation between them is badly known, and L
        /// would turn by a rounding over |M + M₊|. It is turned back to where it was.
        /// </summary>
        private void KeepDirection(Vector3d momentum)
        {
            Vector3d now = _q.Rotate(new Vector3d(_shape.I1 * _w.X, _w.Y, _shape.I3 * _w.Z));
            Vector3d back = 0.5 / now.LengthSquared * Vector3d.Cross(now, momentum);
            SmallTurn.Add(ref _q, ref _qLost, new Quaterniond(0, back) * _q);
        }

        private void Change(double d1, double d2, double d3)
        {
            RunningSum.Add(ref _w.X, ref _wLost.X, d1);
            RunningSum.Add(ref _w.Y, ref _wLost.Y, d2);
            RunningSum.Add(ref _w.Z, ref _wLost.Z, d3);
        }

        private void Invariants(out double energy, out double separation)
        {
            TopShape s = _shape;
            energy = s.I1 * _w.X * _w.X + _w.Y * _w.Y + s.I3 * _w.Z * _w.Z;
            separation = s.M1 * _w.X * _w.X - s.M3 * _w.Z * _w.Z;
        }

        private void Fold()
        {
            double left = _energy * (_scale * _scale) > Resting ? _scale : 0;
            _w = left * _w;
            _wLost = left * _wLost;
            _energy *= left * left;
            _separation *= left * left;
            _scale = 1;
            _preparedFor = double.NaN;
        }
    }
}
