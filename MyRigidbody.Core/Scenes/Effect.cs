namespace RigidBodyDynamics
{
    /// <summary>An effect of a scene, and when it acts: during the steps that start at From ≤ t &lt; To; an impulse at From, which is To.</summary>
    public abstract class Effect
    {
        internal Effect(double from, double to)
        {
            From = !double.IsNaN(from) ? from : throw Guard.Refused("from", from, "must be a time");
            To = to > from ? to : throw Guard.Refused("to", to, "must be later than from");
        }

        internal Effect(double time) => From = To = Guard.NotNegative(time, "time");

        /// <summary>Start of the time in which it acts, s.</summary>
        public double From { get; }

        /// <summary>End of the time in which it acts, s; infinite if it has none.</summary>
        public double To { get; }

        /// <summary>The <see cref="IPush"/>, <see cref="ICoast"/> or <see cref="Impulse"/> itself.</summary>
        public abstract IEffect Motion { get; }

        /// <summary>The same where a body coasts with it; null for a push that depends on the time or the orientation.</summary>
        internal ICoast Coast =>
            Motion is IPush && (Motion.Traits & (EffectTraits.ReadsTime | EffectTraits.ReadsOrientation)) != 0 ? null : Motion as ICoast;
    }

    /// <summary>An effect that is no push: a body coasts with it, or loses mass.</summary>
    internal sealed class PlainEffect : Effect
    {
        public PlainEffect(IEffect motion, double from, double to) : base(from, to) => Motion = motion;

        public override IEffect Motion { get; }
    }

    /// <summary>An effect at the beginning of one step.</summary>
    internal sealed class ImpulseEffect : Effect
    {
        public ImpulseEffect(Impulse impulse, double time) : base(time) => Impulse = impulse;

        public Impulse Impulse { get; }

        public override IEffect Motion => Impulse;
    }

    /// <summary>An effect that pushes, its type forgotten.</summary>
    internal abstract class PushEffect : Effect
    {
        protected PushEffect(double from, double to) : base(from, to) { }

        public abstract IPush Push { get; }

        /// <summary>Remembers the type: adds this effect to a sum and goes on with the next.</summary>
        public abstract Stretch<TIntegrator> Join<TIntegrator, TSum>(TSum sum, StretchBuilder<TIntegrator> builder, int next)
            where TIntegrator : struct, IIntegrator
            where TSum : struct, IPush;
    }

    /// <summary>An effect that pushes, its type known.</summary>
    internal sealed class PushEffect<TPush> : PushEffect where TPush : struct, IPush
    {
        private readonly TPush _push;

        public PushEffect(TPush push, double from, double to) : base(from, to) => _push = push;

        public override IPush Push => _push;

        public override IEffect Motion => _push;

        public override Stretch<TIntegrator> Join<TIntegrator, TSum>(TSum sum, StretchBuilder<TIntegrator> builder, int next) =>
            builder.Bind(new Both<TSum, TPush>(sum, _push), next);
    }
}
