#if NET
using System;
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    internal readonly partial struct Decay
    {
        /// <summary>A number of each body after the damping.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Lanes Of(Lanes x)
        {
            Lanes left = Math.Abs(_lost) < 0.5 ? x - new Lanes(_lost) * x : new Lanes(_left) * x;
            return IsNone ? left : Rest(left);
        }

        /// <summary>Subtracts the damped part from a running sum of each body.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Take(ref Lanes x, ref Lanes lost)
        {
            if (IsNone)
                return;

            lost = new Lanes(_left) * lost;
            if (Math.Abs(_lost) < 0.5)
                RunningSum.Add(ref x, ref lost, new Lanes(-_lost) * x);
            else
                x = new Lanes(_left) * x;

            x = Rest(x);
            lost = Rest(lost);
        }

        /// <summary>The same for a vector of each body.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Take(ref VectorLanes v, ref VectorLanes lost)
        {
            Take(ref v.X, ref lost.X);
            Take(ref v.Y, ref lost.Y);
            Take(ref v.Z, ref lost.Z);
        }

        /// <summary>A vector of each body after a factor alone.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static VectorLanes By(double factor, VectorLanes v)
        {
            VectorLanes left = factor * v;
            return factor == 1 ? left : new VectorLanes(Rest(left.X), Rest(left.Y), Rest(left.Z));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Lanes Rest(Lanes x) => Vector.ConditionalSelect(Vector.LessThan(Vector.Abs(x), new Lanes(Least)), 0 * x, x);
    }

    internal readonly partial struct Drift
    {
        /// <summary>Moves the centres of mass of several bodies.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Move(ref VectorLanes x, ref VectorLanes xLost, ref VectorLanes v, ref VectorLanes vLost)
        {
            RunningSum.Add(ref x, ref xLost, _s * v + new VectorLanes(_fall));
            _decay.Take(ref v, ref vLost);
            RunningSum.Add(ref v, ref vLost, new VectorLanes(_gain));
        }
    }

    internal static partial class RunningSum
    {
        /// <summary>Adds to a number of each body.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref Lanes sum, ref Lanes lost, Lanes add)
        {
            Lanes all = add + lost, next = sum + all;
            lost = all - (next - sum);
            sum = next;
        }

        /// <summary>Adds to a vector of each body.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref VectorLanes sum, ref VectorLanes lost, VectorLanes add)
        {
            Add(ref sum.X, ref lost.X, add.X);
            Add(ref sum.Y, ref lost.Y, add.Y);
            Add(ref sum.Z, ref lost.Z, add.Z);
        }
    }

    internal static partial class SmallTurn
    {
        /// <summary>r − 1 for several bodies at once.</summary>
        public static QuaternionLanes Of(VectorLanes axis, Lanes length, double time)
        {
            Elementary.SinCosOf(0.25 * length * time, out Lanes sin, out Lanes cos);
            VectorLanes turn = 2 * sin * cos / length * axis;
            Lanes w = -2 * sin * sin, zero = Lanes.Zero;
            Masks isNone = Vector.Equals(length, zero);
            return QuaternionLanes.Choose(isNone, new QuaternionLanes(zero, zero, zero, zero), new QuaternionLanes(w, turn));
        }

        /// <summary>The same for several bodies.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(ref QuaternionLanes q, ref QuaternionLanes lost, QuaternionLanes d)
        {
            Lanes stretch = new Lanes(0.5) * (Lanes.One - q.LengthSquared);
            RunningSum.Add(ref q.W, ref lost.W, d.W + stretch * (q.W + d.W));
            RunningSum.Add(ref q.X, ref lost.X, d.X + stretch * (q.X + d.X));
            RunningSum.Add(ref q.Y, ref lost.Y, d.Y + stretch * (q.Y + d.Y));
            RunningSum.Add(ref q.Z, ref lost.Z, d.Z + stretch * (q.Z + d.Z));
        }
    }
}
#endif
