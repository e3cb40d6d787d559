using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Rotations stored as r − 1 instead of r, and added to an orientation as an increment. A rotation by a small angle φ then
    /// keeps its digits: in r, cos(φ/2) rounds to 1 and every product has the rounding error of a large rotation.
    /// </summary>
    internal static partial class SmallTurn
    {
        /// <summary>r − 1 of the rotation about an axis of the given length, at length rad/s for a time.</summary>
        public static Quaterniond Of(Vector3d axis, double length, double time)
        {
            if (length == 0)
                return new Quaterniond(0, 0, 0, 0);

            Elementary.SinCos(0.25 * length * time, out double sin, out double cos);
            return new Quaterniond(-2 * sin * sin, 2 * sin * cos / length * axis);
        }

        /// <summary>
        /// (q + d)(3 − |q|²)/2: adds the increment d to an orientation and keeps its length at 1. The rounding error of the sum is
        /// stored in lost and added with the next increment (Kahan): for slow bodies it is most of the error.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref Quaterniond q, ref Quaterniond lost, Quaterniond d)
        {
            double stretch = 0.5 * (1 - q.LengthSquared);
            double w = q.W, x = q.X, y = q.Y, z = q.Z;
            RunningSum.Add(ref q.W, ref lost.W, d.W + stretch * (w + d.W));
            RunningSum.Add(ref q.X, ref lost.X, d.X + stretch * (x + d.X));
            RunningSum.Add(ref q.Y, ref lost.Y, d.Y + stretch * (y + d.Y));
            RunningSum.Add(ref q.Z, ref lost.Z, d.Z + stretch * (z + d.Z));
        }
    }
}
