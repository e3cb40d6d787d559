namespace RigidBodyDynamics
{
    /// <summary>An effect of a scene, and its time: the steps that start at From ≤ t &lt; To; for an impulse From equals To.</summary>
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

        /// <summary>The effect as one with a closed form; null for a push that depends on time or orientation.</summary>
        internal ICoast Coast =>
            Motion is IPush && (Motion.Traits & (EffectTraits.ReadsTime | EffectTraits.ReadsOrientation)) != 0 ? null : Motion as ICoast;
    }

    /// <summary>An effect without a force of its own: it has a closed form, or changes the mass.</summary>
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

    /// <summary>A push, behind its interface.</summary>
    internal abstract class PushEffect : Effect
    {
        protected PushEffect(double from, double to) : base(from, to) { }

        public abstract IPush Push { get; }

        /// <summary>Adds this push, with its type, to a sum and continues with the next.</summary>
        public abstract Stretch<TIntegrator> Join<TIntegrator, TSum>(TSum sum, StretchBuilder<TIntegrator> builder, int next)
            where TIntegrator : struct, IIntegrator
            where TSum : struct, IPush;
    }

    /// <summary>A push with its type.</summary>
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
