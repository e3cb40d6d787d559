using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Exact free rotation of a body with three different moments: one rational map per step, with constants that are valid until
    /// a torque acts on the body. No trigonometry, no iteration.
    /// </summary>
    /// <remarks>
    /// The body rotates by the smallest rotation that takes M₊ = I w₊ to M, then about L by ψ (<see cref="OrbitStep"/>).
    /// The constants belong to one orbit, and a rounding moves w away from it; under the map that error grows exponentially. So
    /// each step also returns w to its energy and its Q, by corrections of the size of a rounding.
    /// Rounding errors of q and w are carried along (Kahan), for slow bodies the larger part of the error.
    /// </remarks>
    internal partial struct AsymmetricTop : IFreeTop
    {
        // stored invariants within this part of those of w are the remains of a body brought to rest
        internal const double SameInvariant = 1e-12;
        // w and q must not underflow when squared twice
        internal const double Resting = 1e-150;
        // the square of an angle so small that 1e18 of them are negligible
        internal const double NoTurn = 1e-72;
        // 1 − cos(ψ/2) of about a radian; by more, what is added to q would no longer bring |q| back to 1
        internal const double LargestVersine = 0.125;
        // near the unstable axis one step over many flips loses the small components
        internal const double LongestNearUnstable = 15;
        // where even this many parts do not suffice, no digit of the input is left to be saved
        private const long MostParts = 1000;
        // (sine of) the largest angle at which a correction may be made at the wrong end of a step
        internal const double ShortSquared = 0.25 * 0.25;
        internal const double Tiny = 1e-290;
        // (rad of) the angles between which a step that occurs once is prepared in twice the digits: below, a double suffices; above, no digit is left
        internal const double OrdinarySquared = 4.0 * 4, LostSquared = 1e15 * 1e15;
        // 1/√(1 − ε) − 1 = Σ Yₙ εⁿ; the remainder is below 1e-17 for a short rotation
        internal const double Y1 = 1 / 2.0, Y2 = 3 / 8.0, Y3 = 5 / 16.0, Y4 = 35 / 128.0, Y5 = 63 / 256.0, Y6 = 231 / 1024.0;
        internal const double Y7 = 429 / 2048.0, Y8 = 6435 / 32768.0;
        // damping is multiplied into w before pushes over it, raised to the sixth power, overflow
        internal const double LeastScale = 1e-20;

        // set after a push or a change of the step length; when the step repeats, it is prepared again, with the digits that repeated
        // steps would lose
        internal const double ForOneStep = double.PositiveInfinity;

        private TopShape _shape;
        private Vector3d _w, _wLost;
        private Quaterniond _q, _qLost;
        private double _energy, _separation, _scale;
        private OrbitStep _orbit;
        private double _preparedFor, _inverseEnergy;
        private long _count;
        private bool _isShort;
        // for a short rotation: k over w₂², the factors of the products of w, 1 − c₁ c₃, cos(ψ/2)/L²
        private double _kOfSquare, _s1, _s2, _s3, _v13, _cosine;

        public Quaterniond Orientation => _shape.Axes.ToBody(_q);

        public Vector3d AngularVelocity => _shape.Axes.ToWorld(_q.Rotate(_scale * _w));

        public bool IsFinite => Guard.IsFinite(_q.LengthSquared + _w.LengthSquared);

        /// <summary>False near the unstable axis, where a long step is many short rotations.</summary>
        public bool HasClosedForm => !IsNearUnstableAxis(Math.Max(_shape.AlphaOfA3 * A3, _shape.BetaOfA1 * A1));

        private double A1 => _shape.I1 * (_w.X * _w.X) + _shape.G1 * (_w.Y * _w.Y);

        private double A3 => _shape.I3 * (_w.Z * _w.Z) + _shape.G3 * (_w.Y * _w.Y);

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
            _separation = _shape.Long.Invariants(w, out DoubleDouble energy, out _).High;
            _energy = energy.High;
        }

        public void Kick(in Vector3d world, in Vector3d body)
        {
            Vector3d j = world.IsZero ? Vector3d.Zero : _q.RotateInverse(_shape.Axes.FromWorld(world));
            j = body.IsZero ? j : j + _shape.Axes.FromBody(body);
            // w is ω without the damping, whose factor is _scale; multiplied into w at every push, a rounded factor would accumulate error
            j = _scale == 1 ? j : 1 / _scale * j;
            TopShape s = _shape;
            double d1 = s.InverseMoments.X * j.X, d2 = s.InverseMoments.Y * j.Y, d3 = s.InverseMoments.Z * j.Z;
            // computed from the exact change of w: from the rounded w, energy and Q would lose the digits they are stored for
            double e1 = (2 * _w.X + d1) * d1, e2 = (2 * _w.Y + d2) * d2, e3 = (2 * _w.Z + d3) * d3;
            _energy += s.I1 * e1 + e2 + s.I3 * e3;
            _separation += s.M1 * e1 - s.M3 * e3;
            RunningSum.Add(ref _w.X, ref _wLost.X, d1);
            RunningSum.Add(ref _w.Y, ref _wLost.Y, d2);
            RunningSum.Add(ref _w.Z, ref _wLost.Z, d3);
            _preparedFor = double.NaN;
        }

        public void Damp(in Decay decay)
        {
            if (decay.IsNone)
                return;

            // L' = L × ω − c L is free rotation of M = L e^(ct) in the time s, s' = e^(−ct): w itself does not change
            _scale = decay.Of(_scale);
            _preparedFor = double.NaN;
            if (_scale < LeastScale)
                Fold();
        }

        public void Advance(double time)
        {
            time *= _scale;
            if (time != _preparedFor)
                Prepare(time);

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

        /// <summary>Computes the constants of the orbit, for a time of the undamped motion.</summary>
        internal void Prepare(double time)
        {
            TopShape s = _shape;
            double w11 = _w.X * _w.X, w22 = _w.Y * _w.Y, w33 = _w.Z * _w.Z;
            double a1 = s.I1 * w11 + s.G1 * w22, a3 = s.I3 * w33 + s.G3 * w22;
            double energy = s.I1 * w11 + w22 + s.I3 * w33, separation = s.M1 * w11 - s.M3 * w33;
            _energy = Math.Abs(_energy - energy) <= SameInvariant * energy ? _energy : energy;
            _separation = Math.Abs(_separation - separation) <= SameInvariant * (s.G3 * a1 + s.G1 * a3) ? _separation : separation;
            bool isKept = _preparedFor == ForOneStep;
            _preparedFor = isKept ? time : ForOneStep;
            _isShort = false;
            _count = _energy > Resting && _energy * time * time > NoTurn ? 1 : 0;
            if (_count == 0)
                return;

            double rate = Math.Max(s.AlphaOfA3 * a3, s.BetaOfA1 * a1), turned = _energy * _energy * (time * time), momentum = s.I1 * a1 + s.I3 * a3;
            if (IsNearUnstableAxis(rate) && rate * time * time > LongestNearUnstable * LongestNearUnstable)
                _count = (long)Math.Ceiling(Math.Min(MostParts, Math.Sqrt(rate) * Math.Abs(time) / LongestNearUnstable));

            isKept |= turned > OrdinarySquared * momentum && turned < LostSquared * momentum;
            _inverseEnergy = 0.5 / _energy;
            _orbit.Set(s, a1, a3, _separation, time / _count, _w, _wLost, isKept);
            while (_orbit.IsIllConditioned && _count < MostParts)
                _orbit.Set(s, a1, a3, _separation, time / ++_count, _w, _wLost, isKept);

            // M rotates in the body by less than the square root of the first: its greatest rate, squared, is −(α − β)/Q A₁ A₃/L², which is less than α
            // where I₁ A₁ is less than its part of L², and less than β where I₃ A₃ is
            _isShort = _count == 1 && rate * _orbit.S * _orbit.S <= ShortSquared && _orbit.C1 > 0 && _orbit.C3 > 0 && _orbit.Versine <= LargestVersine;
            if (_isShort)
                Derive();
        }

        private bool IsNearUnstableAxis(double rate) => Math.Abs(_shape.DeltaOfQ * _separation) < 0.01 * rate;

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
