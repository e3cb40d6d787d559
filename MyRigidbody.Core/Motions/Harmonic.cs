using System.Globalization;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A vector constant + sine · sin(rate t) + cosine · cos(rate t), which <see cref="Force"/> and <see cref="Torque"/> share.</summary>
    internal readonly struct Harmonic
    {
        private readonly Vector3d _constant;
        private readonly Vector3d _sine;
        private readonly Vector3d _cosine;
        private readonly double _rate;

        /// <summary>True unless it is constant.</summary>
        public readonly bool Swings;

        public Harmonic(Vector3d constant, Vector3d sine, Vector3d cosine, double rate, string name = "constant")
        {
            _constant = Guard.Finite(constant, name);
            _sine = Guard.Finite(sine, "sin");
            _cosine = Guard.Finite(cosine, "cos");
            _rate = Guard.Finite(rate, "rate");
            Swings = !(sine.IsZero && cosine.IsZero);
        }

        /// <summary>
        /// The mean over a time. The mean of sin(rate t) from t to t + h is sin at the middle, times sin(z)/z with z = rate h/2, without
        /// a difference of cosines, which would cancel for short steps.
        /// </summary>
        public Vector3d Mean(double time, double duration)
        {
            Vector3d mean = Vector3d.Zero;
            Add(time, duration, 1, ref mean);
            return mean;
        }

        /// <summary>Adds a multiple of the mean to a sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(double time, double duration, double factor, ref Vector3d sum)
        {
            if (Swings)
                AddSwinging(time + 0.5 * duration, duration == 0 ? 1 : Spread(0.5 * _rate * duration), factor, ref sum);
            else
                _constant.AddTo(ref sum, factor);
        }

        // a method of its own, because a sine is long code, and the step around it is optimised well only while it is short
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void AddSwinging(double middle, double spread, double factor, ref Vector3d sum)
        {
            Elementary.SinCos(_rate * middle, out double sin, out double cos);
            sum.X += factor * (_constant.X + spread * (sin * _sine.X + cos * _cosine.X));
            sum.Y += factor * (_constant.Y + spread * (sin * _sine.Y + cos * _cosine.Y));
            sum.Z += factor * (_constant.Z + spread * (sin * _sine.Z + cos * _cosine.Z));
        }

        /// <summary>The vector in words.</summary>
        public override string ToString() => !Swings ? _constant.ToString() : string.Format(
            CultureInfo.InvariantCulture, "{0} + {1} sin({3:R} t) + {2} cos({3:R} t)", _constant, _sine, _cosine, _rate);

        // sin(z)/z; its series where the first omitted term is below a rounding
        private static double Spread(double z)
        {
            double zz = z * z;
            return zz > 0.01 ? Elementary.Sin(z) / z : 1 - zz / 6 * (1 - zz / 20 * (1 - zz / 42 * (1 - zz / 72)));
        }
    }
}
