using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The exact flow of coasting over one duration: v' = g − c v has v = e^(−ch) v₀ + s g and x = x₀ + s v₀ + r g with
    /// s = (1 − e^(−ch))/c and r = (h − s)/c; and under L' = −c L the body rotates as far as a free one in the time s.
    /// </summary>
    internal readonly partial struct Drift
    {
        /// <summary>The time in which a free body rotates as far as the damped one, s.</summary>
        public readonly double TurningTime;

        /// <summary>True if neither gravity nor damping acts.</summary>
        public readonly bool IsFree;

        /// <summary>The damping of ω.</summary>
        public readonly Decay AngularDecay;

        private readonly double _s;
        private readonly Decay _decay;
        private readonly Vector3d _fall;
        private readonly Vector3d _gain;

        /// <summary>The flow, without the factors per step.</summary>
        public Drift(in Coasting coasting, double duration)
        {
            AngularDecay = Of(coasting.AngularDampingRate, duration, out TurningTime, out _);
            _decay = Of(coasting.LinearDampingRate, duration, out _s, out double r);
            _fall = r * coasting.Acceleration;
            _gain = _s * coasting.Acceleration;
            IsFree = coasting.Acceleration.IsZero && coasting.LinearDampingRate == 0 && coasting.AngularDampingRate == 0;
        }

        /// <summary>Moves a centre of mass, with compensated sums.</summary>
        public void Move(ref Vector3d x, ref Vector3d xLost, ref Vector3d v, ref Vector3d vLost)
        {
            RunningSum.Add(ref x, ref xLost, _s * v + _fall);
            _decay.Take(ref v, ref vLost);
            RunningSum.Add(ref v, ref vLost, _gain);
        }

        /// <summary><see cref="TurningTime"/> in twice the digits.</summary>
        public static DoubleDouble TurningTimeOf(double rate, DoubleDouble duration)
        {
            DoubleDouble z = rate * duration;
            if (z.High == 0)
                return duration;

            // 1 − e^(−z) by its series for a small z, and then 1 − e^(−2z) = p (2 − p)
            int doublings = 0;
            for (; Math.Abs(z.High) > 0.0625 && doublings < 64; doublings++)
                z = 0.5 * z;

            DoubleDouble p = 0;
            for (int k = 20; k >= 1; k--)
                p = z / k * (1 - p);

            for (; doublings > 0; doublings--)
                p = p * (2 - p);

            return p / rate;
        }

        // with φ₁ and φ₂ nothing cancels for small c h, and 1 − e^(−ch) is c s
        private static Decay Of(double rate, double h, out double s, out double r)
        {
            double z = rate * h;
            s = rate == 0 ? h : h * Elementary.Phi1(z);
            r = rate == 0 ? 0.5 * h * h : h * h * Elementary.Phi2(z);
            double left = rate == 0 ? 1 : Elementary.Exp(-z);
            return new Decay(left, Math.Abs(z) < 1 ? rate * s : 1 - left);
        }
    }
}
