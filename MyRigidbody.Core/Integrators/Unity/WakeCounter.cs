using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// When PhysX puts a body to sleep: a counter runs down while the *sum* of the body's velocities over the last steps is
    /// small, and is reset when it is not.
    /// </summary>
    internal struct WakeCounter<R> where R : struct, IRounding
    {
        // the counter decides in which step sleep begins, so it runs in float in every precision
        private const float Full = 20f * 0.02f;
        private const float Half = Full * 0.5f;

        private float _left;
        private RealVector<R> _sumV, _sumW;
        private Real<R> _threshold;

        public WakeCounter(double left, double threshold)
        {
            _left = (float)left;
            _threshold = threshold;
            _sumV = _sumW = default(RealVector<R>);
        }

        /// <summary>Seconds left; 0 while asleep.</summary>
        public float Left => _left;

        public bool NeverSleeps => _threshold.IsZero;

        /// <summary>Called for a force or torque.</summary>
        public void Wake() => _left = Math.Max(_left, Full);

        /// <summary>True if the body sleeps during the step that begins.</summary>
        public bool Sleeps()
        {
            if (_left != 0 || NeverSleeps)
                return false;

            _sumV = _sumW = default(RealVector<R>);
            return true;
        }

        /// <summary>Runs the counter for a step.</summary>
        /// <param name="h">Its length, s.</param>
        /// <param name="v">Velocity, m/s.</param>
        /// <param name="w">Angular velocity in principal axes, rad/s.</param>
        /// <param name="inverseMass">1/kg.</param>
        /// <param name="moments">kg m².</param>
        public void Run(double h, RealVector<R> v, RealVector<R> w, Real<R> inverseMass, RealVector<R> moments)
        {
            if (NeverSleeps)
                return;

            float step = (float)h;
            if (_left < Half || _left < step)
            {
                _sumV += v;
                _sumW += w;
                Real<R> energy = 0.5 * (moments.Dot(_sumW.Scale(_sumW)) * inverseMass + _sumV.Dot(_sumV));
                if (!(energy < _threshold))
                {
                    _sumV = _sumW = default(RealVector<R>);
                    float ratio = (float)(double)(energy / _threshold).AtMost(2.0);
                    _left = (float)((float)(ratio * 0.5f) * Full);
                    return;
                }
            }

            _left = Math.Max((float)(_left - step), 0f);
            if (_left == 0)
                _sumV = _sumW = default(RealVector<R>);
        }
    }
}
