using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// What a velocity loses by damping, kept as the part that is lost beside the part that is left: v − lost · v rounds
    /// now up, now down, where left · v repeats the rounding of e^(−ch) at every step, and a million steps add it up.
    /// </summary>
    internal readonly struct Decay
    {
        private readonly double _left;
        private readonly double _lost;

        /// <summary>Of the parts left and lost, which make 1 together.</summary>
        public Decay(double left, double lost)
        {
            _left = left;
            _lost = lost;
        }

        /// <summary>By a factor.</summary>
        public static Decay To(double factor) => new Decay(factor, 1 - factor);

        /// <summary>True if nothing is lost.</summary>
        public bool IsNone => _lost == 0;

        /// <summary>What is left of a number.</summary>
        public double Of(double x) => Math.Abs(_lost) < 0.5 ? x - _lost * x : _left * x;

        /// <summary>What is left of a vector.</summary>
        public Vector3d Of(Vector3d v) => Math.Abs(_lost) < 0.5 ? v - _lost * v : _left * v;
    }
}
