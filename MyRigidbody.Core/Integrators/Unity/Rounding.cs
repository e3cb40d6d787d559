using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>The precision to which every single operation is rounded.</summary>
    internal interface IRounding
    {
        /// <summary>The nearest number of that precision.</summary>
        double Round(double value);

        /// <summary>Sine and cosine of a number of that precision (rad), not yet rounded to it.</summary>
        void SinCos(double angle, out double sin, out double cos);
    }

    /// <summary>Single precision, as Unity's physics computes.</summary>
    /// <remarks>
    /// A sum, product, quotient or root of two floats, taken in double and then rounded to float, is the float result
    /// to the last bit, because 53 ≥ 2·24 + 2 (Figueroa, When is double rounding innocuous?, 1995). So this also
    /// holds on runtimes that compute float in double, as Unity's own does.
    /// </remarks>
    internal struct ToSingle : IRounding
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double Round(double value) => (float)value;

        public void SinCos(double angle, out double sin, out double cos) => SingleSine.SinCos(angle, out sin, out cos);
    }

    /// <summary>Double precision: no rounding beyond the processor's own.</summary>
    internal struct ToDouble : IRounding
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double Round(double value) => value;

        public void SinCos(double angle, out double sin, out double cos) => Elementary.SinCos(angle, out sin, out cos);
    }
}
