using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A number of the precision R, so that one source text of the integrator serves float and double.</summary>
    internal readonly struct Real<R> where R : struct, IRounding
    {
        private readonly double _value;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private Real(double value)
        {
            _value = default(R).Round(value);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static implicit operator Real<R>(double value) => new Real<R>(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static explicit operator double(Real<R> a) => a._value;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Real<R> operator +(Real<R> a, Real<R> b) => new Real<R>(a._value + b._value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Real<R> operator -(Real<R> a, Real<R> b) => new Real<R>(a._value - b._value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Real<R> operator -(Real<R> a) => new Real<R>(-a._value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Real<R> operator *(Real<R> a, Real<R> b) => new Real<R>(a._value * b._value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Real<R> operator /(Real<R> a, Real<R> b) => new Real<R>(a._value / b._value);

        public static bool operator <(Real<R> a, Real<R> b) => a._value < b._value;

        public static bool operator >(Real<R> a, Real<R> b) => a._value > b._value;

        public bool IsZero => _value == 0;

        public Real<R> Sqrt() => new Real<R>(Math.Sqrt(_value));

        public Real<R> AtLeast(Real<R> least) => _value > least._value ? this : least;

        public Real<R> AtMost(Real<R> most) => _value < most._value ? this : most;

        public void SinCos(out Real<R> sin, out Real<R> cos)
        {
            default(R).SinCos(_value, out double s, out double c);
            sin = s;
            cos = c;
        }
    }
}
