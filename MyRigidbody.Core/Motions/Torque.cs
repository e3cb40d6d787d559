using System.Globalization;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A torque constant + sine · sin(rate t) + cosine · cos(rate t), in world or in body axes.</summary>
    public readonly struct Torque : IPush
    {
        private readonly Vector3d _constant;
        private readonly Vector3d _sine;
        private readonly Vector3d _cosine;
        private readonly double _rate;
        private readonly bool _inBody;
        private readonly bool _swings;

        /// <summary>The torque, N m, with rate in rad/s.</summary>
        /// <param name="constant">The part that does not change, N m.</param>
        /// <param name="sine">Factor of sin(rate t), N m.</param>
        /// <param name="cosine">Factor of cos(rate t), N m.</param>
        /// <param name="rate">rad/s.</param>
        /// <param name="inBody">True: along body axes, and turns with the body. False: along world axes.</param>
        public Torque(Vector3d constant, Vector3d sine, Vector3d cosine, double rate, bool inBody)
        {
            _constant = Guard.Finite(constant, "constant");
            _sine = Guard.Finite(sine, "sin");
            _cosine = Guard.Finite(cosine, "cos");
            _rate = Guard.Finite(rate, "rate");
            _inBody = inBody;
            _swings = !(sine.IsZero && cosine.IsZero);
        }

        /// <summary>A constant torque along world axes, N m.</summary>
        public static Torque Constant(Vector3d torque) => new Torque(torque, Vector3d.Zero, Vector3d.Zero, 0, false);

        public EffectTraits Traits => _swings ? EffectTraits.Turns | EffectTraits.ReadsTime : EffectTraits.Turns;

        // a sine is long, and the step around it is compiled well only while it is short
        [MethodImpl(MethodImplOptions.NoInlining)]
        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Add(Mean(now.Time, 0), ref wrench);

        [MethodImpl(MethodImplOptions.NoInlining)]
        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            Add(duration * Mean(now.Time, now.IsHeld ? 0 : duration), ref impulse);

        /// <summary>In words.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture,
            "torque {0}{1} N m, {2} axes",
            _constant,
            _swings ? string.Format(CultureInfo.InvariantCulture, " + {0} sin({2:R} t) + {1} cos({2:R} t)", _sine, _cosine, _rate) : string.Empty,
            _inBody ? "body" : "world");

        /// <summary>
        /// The torque's mean over a time. The mean of sin(rate t) from t to t + h is sin at the middle, times
        /// sin(z)/z with z = rate h/2; no difference of cosines that would cancel for short steps.
        /// </summary>
        private Vector3d Mean(double time, double duration)
        {
            if (!_swings)
                return _constant;

            double z = 0.5 * _rate * duration;
            double spread = duration == 0 ? 1 : Spread(z);
            Elementary.SinCos(_rate * (time + 0.5 * duration), out double sin, out double cos);
            return _constant + spread * (sin * _sine + cos * _cosine);
        }

        // sin(z)/z; its series where the first term left out is below a rounding
        private static double Spread(double z)
        {
            double zz = z * z;
            return zz > 0.01 ? Elementary.Sin(z) / z : 1 - zz / 6 * (1 - zz / 20 * (1 - zz / 42 * (1 - zz / 72)));
        }

        private void Add(Vector3d torque, ref Wrench wrench)
        {
            if (_inBody)
                wrench.BodyTorque += torque;
            else
                wrench.Torque += torque;
        }
    }
}
