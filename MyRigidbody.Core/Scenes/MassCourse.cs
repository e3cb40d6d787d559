using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The mass of a body over a stretch of time, as a part of its first mass m: r = r₀ + r' t. The moments change in proportion, so
    /// r m v' = F and r (I ω' + ω × I ω) = τ are the motion of the body with its first mass, under F / r and τ / r; where momentum is kept,
    /// under −r' m v / r and −r' I ω / r in addition. So no integrator needs to treat it: it is a push around each push.
    /// </summary>
    /// <remarks>
    /// The mean of 1/r over a time is a logarithm, computed exactly. So where time passes while pushes act, as in Splitting and Exact, a
    /// constant force in world axes gives v exactly in steps of any length (a rocket's v = u ln m₀/m₁), and so does the term that keeps
    /// momentum; every other push has the order of the integrator.
    /// </remarks>
    internal sealed class MassCourse
    {
        // below this (b − a)/(b + a), a logarithm is computed by its series
        private const double Near = 0.05;

        [ThreadStatic]
        private static MassProperties _real;

        private readonly double _starts, _rate, _shed;

        /// <param name="starts">The start of the stretch, s.</param>
        /// <param name="ratio">The part of the mass at that time.</param>
        /// <param name="rate">Its rate, 1/s.</param>
        /// <param name="shed">The part of the rate that keeps momentum, 1/s.</param>
        public MassCourse(double starts, double ratio, double rate, double shed)
        {
            _starts = starts;
            Ratio = ratio;
            _rate = rate;
            _shed = shed;
            Shedding = shed == 0 ? null : new Shed(this);
        }

        /// <summary>The part of the mass at the start.</summary>
        public double Ratio { get; }

        /// <summary>The term that keeps the momentum, as a push on the body with its first mass; null where velocity is kept.</summary>
        public IPush Shedding { get; }

        /// <summary>The part of the mass at a time.</summary>
        public double At(double time) => Ratio + _rate * (time - _starts);

        /// <summary>A push on the body as it is, as one on the body with its first mass.</summary>
        public IPush On(IPush push) => new Lighter(push, this);

        /// <summary>The mean of 1/r over a time.</summary>
        private double Inverse(in Instant now, double duration) =>
            now.IsHeld || _rate == 0 ? 1 / At(now.Time) : Inverse(At(now.Time), At(now.Time + duration));

        private static double Inverse(double a, double b)
        {
            double z = (b - a) / (b + a), zz = z * z, middle = 0.5 * (a + b);
            if (Math.Abs(z) > Near)
                return 0.5 * (Inverse(a, middle) + Inverse(middle, b));

            // ln(b/a)/(b − a) = artanh(z)/z / middle
            return (1 + zz * (1.0 / 3 + zz * (1.0 / 5 + zz * (1.0 / 7 + zz * (1.0 / 9 + zz / 11))))) / middle;
        }

        private sealed class Lighter : IPush
        {
            private readonly IPush _push;
            private readonly MassCourse _course;

            public Lighter(IPush push, MassCourse course)
            {
                _push = push;
                _course = course;
            }

            public EffectTraits Traits => (_push.Traits | EffectTraits.ReadsTime) & ~EffectTraits.HasPotential;

            public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
            {
                double ratio = _course.At(now.Time);
                Wrench real = default(Wrench);
                _push.At(now, body, Real(mass, ratio), ref real);
                wrench = wrench.With(real.Times(1 / ratio));
            }

            public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
            {
                double inverse = _course.Inverse(now, duration);
                Wrench before = impulse.Times(1 / inverse), real = before;
                _push.Over(now, duration, body, Real(mass, 1 / inverse), ref real);
                impulse = impulse.With(real.With(before.Times(-1)).Times(inverse));
            }

            // overwritten at every call, so that a step allocates nothing: a push may read it, but not keep it
            private static MassProperties Real(MassProperties mass, double ratio) => (_real ?? (_real = mass.Times(1))).Become(mass, ratio);
        }

        private sealed class Shed : IPush
        {
            private readonly MassCourse _course;

            public Shed(MassCourse course) => _course = course;

            public EffectTraits Traits => new MassRate(1, Keeping.Momentum).Traits;

            public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
                wrench = wrench.With(Momentum(body, mass).Times(-_course._shed / _course.At(now.Time)));

            public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
            {
                double z = _course._shed * duration * _course.Inverse(now, duration);
                impulse = impulse.With(Momentum(impulse.AppliedTo(body, mass), mass).Times(-z * Elementary.Phi1(z)));
            }

            private static Wrench Momentum(in BodyState body, MassProperties mass) =>
                new Wrench { Force = Conserved.Momentum(body, mass), Torque = Conserved.AngularMomentum(body, mass) };
        }
    }
}
