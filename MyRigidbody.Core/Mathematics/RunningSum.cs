using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Compensated sums (Kahan): they add the rounding error of each term with the next, so that a million small terms have the
    /// error of one.
    /// </summary>
    internal static partial class RunningSum
    {
        /// <summary>Adds to a number.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref double sum, ref double lost, double add)
        {
            double all = add + lost, next = sum + all;
            lost = all - (next - sum);
            sum = next;
        }

        /// <summary>Adds to a vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref Vector3d sum, ref Vector3d lost, Vector3d add)
        {
            Add(ref sum.X, ref lost.X, add.X);
            Add(ref sum.Y, ref lost.Y, add.Y);
            Add(ref sum.Z, ref lost.Z, add.Z);
        }
    }
}
