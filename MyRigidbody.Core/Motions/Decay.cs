using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The factor of a velocity under damping, stored as the part lost beside the part left: v − lost · v rounds sometimes up, sometimes
    /// down, where left · v repeats the rounding of e^(−ch) in every step, and a million steps accumulate it.
    /// </summary>
    internal readonly partial struct Decay
    {
        private const double Least = 1e-290;
        private readonly double _left;
        private readonly double _lost;

        /// <summary>Of the parts left and lost, whose sum is 1.</summary>
        public Decay(double left, double lost)
        {
            _left = left;
            _lost = lost;
        }

        /// <summary>From a factor.</summary>
        public static Decay To(double factor) => new Decay(factor, 1 - factor);

        /// <summary>True if nothing is lost.</summary>
        public bool IsNone => _lost == 0;

        /// <summary>A number after the damping.</summary>
        public double Of(double x)
        {
            double left = Math.Abs(_lost) < 0.5 ? x - _lost * x : _left * x;
            return IsNone ? left : Rest(left);
        }

        /// <summary>A vector after the damping.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3d Of(Vector3d v)
        {
            Vector3d left = Math.Abs(_lost) < 0.5 ? v - _lost * v : _left * v;
            return IsNone ? left : Rest(left);
        }

        /// <summary>Subtracts the damped part from a running sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Take(ref double x, ref double lost)
        {
            if (IsNone)
                return;

            lost = _left * lost;
            if (Math.Abs(_lost) < 0.5)
                RunningSum.Add(ref x, ref lost, -_lost * x);
            else
                x = _left * x;

            x = Rest(x);
            lost = Rest(lost);
        }

        /// <summary>The same of a vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Take(ref Vector3d v, ref Vector3d lost)
        {
            Take(ref v.X, ref lost.X);
            Take(ref v.Y, ref lost.Y);
            Take(ref v.Z, ref lost.Z);
        }

        /// <summary>A vector after a factor alone.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d By(double factor, Vector3d v) => factor == 1 ? factor * v : Rest(factor * v);

        /// <summary>The same of a number.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static double By(double factor, double x) => Rest(factor * x);

        /// <summary>
        /// A number below 1e-290 becomes zero with its sign: subnormal numbers would follow, which take a processor ten times as
        /// long, in every later step.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double Rest(double x) => Math.Abs(x) < Least ? 0 * x : x;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector3d Rest(Vector3d v) => new Vector3d(Rest(v.X), Rest(v.Y), Rest(v.Z));
    }
}
