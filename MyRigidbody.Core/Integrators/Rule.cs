using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>What a rule keeps of a body that turns freely.</summary>
    [Flags]
    public enum Keeps
    {
        /// <summary>It has no gyroscopic term: ω stays as it is, and with three different moments that is another motion.</summary>
        AngularVelocity = 0,

        /// <summary>It converges to the free motion as the step shrinks. It need not keep anything at a given step.</summary>
        Motion = 1,

        /// <summary>|L| to rounding.</summary>
        MomentumLength = 2,

        /// <summary>The vector L to rounding.</summary>
        Momentum = 4,

        /// <summary>The energy swings within bounds, however long the run.</summary>
        EnergyBounded = 8,

        /// <summary>The energy to rounding, however long the run and the step.</summary>
        Energy = 16,

        /// <summary>The way back: as many steps with all velocities reversed end at the start, under pushes that read the pose alone.</summary>
        WayBack = 32,
    }

    /// <summary>What a step costs, in steps of the lab.</summary>
    internal enum Cost
    {
        /// <summary>Up to one and a half times the lab's step.</summary>
        LikeTheLab,

        /// <summary>More than that.</summary>
        SeveralTimesTheLab,
    }

    /// <summary>A rule by which a body moves, and what it promises. <see cref="Rules"/> has them.</summary>
    public abstract class Rule
    {
        internal Rule(string name, int order, Keeps keeps, Cost cost, string about)
        {
            Name = !string.IsNullOrEmpty(name) ? name : throw Guard.Refused(nameof(name), name, "must not be empty");
            Order = order >= 1 ? order : throw Guard.Refused(nameof(order), order, "must be at least 1");
            Keeps = keeps;
            Cost = cost;
            About = Guard.NotNull(about, nameof(about));
        }

        /// <summary>The name by which scenes and commands call it.</summary>
        public string Name { get; }

        /// <summary>
        /// The error after a given time falls with this power of the step, where the rule converges at all: for every effect and
        /// all of them together, but for those that <see cref="OrderFor"/> knows.
        /// </summary>
        public int Order { get; }

        /// <summary>What it keeps of a body that turns freely.</summary>
        public Keeps Keeps { get; }

        /// <summary>What a step costs.</summary>
        internal Cost Cost { get; }

        /// <summary>One line about it.</summary>
        public string About { get; }

        /// <summary>
        /// The order for a body. It is <see cref="Order"/>, and 1 by every rule where velocities are multiplied once a step
        /// (<see cref="DecayPerStep"/>): that comes after all else that acts, held against the rate that it stands for.
        /// </summary>
        public int OrderFor(BodyDescription body)
        {
            Coasting coasting = Coasting.Free;
            foreach (Effect effect in Guard.NotNull(body, nameof(body)).Effects)
                (effect.Motion as ICoast)?.AddTo(ref coasting, body.Mass);

            return coasting.LinearFactorPerStep == 1 && coasting.AngularFactorPerStep == 1 ? Order : 1;
        }

        /// <summary>Its name.</summary>
        public sealed override string ToString() => Name;

        internal LoneMover Build(BodyPlan plan, Clock clock) => Use(plan.Body, new MoverMaker(plan, clock));

        /// <summary>Does something with the rule as a type, the one that suits a body.</summary>
        internal abstract TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use);

        /// <summary>The rotation of a body by this rule, in words.</summary>
        internal virtual string Rotation(BodyDescription body) =>
            "rotation by " + Name + ((Keeps & Keeps.Motion) != 0 ? string.Empty : " (no gyroscopic term)");

        /// <summary>What the rule does of itself, whatever the scene's effects, in words; null if nothing.</summary>
        internal virtual string Settings(BodyDescription body) => null;

        /// <summary>Why a body's rotation is simpler by this rule than that of any body; null if it is not.</summary>
        internal virtual string Simpler(BodyDescription body) => null;

        /// <summary>True if the rule itself holds a body at its locked axes; for all others a <see cref="Bearing"/> does.</summary>
        internal virtual bool HoldsAxes => false;

        /// <summary>True if a constant force is part of what a body coasts with by this rule, and no push.</summary>
        internal virtual bool CoastsUnderForces => true;

        /// <summary>True if a body has a closed form by this rule while a stretch lasts: the rule itself is asked.</summary>
        internal virtual bool Coasts(BodyDescription body, StretchPlan stretch) =>
            stretch.Pushes.Count == 0 && stretch.MassCourse?.Shedding == null && Use(body, new ClosedForm(body, stretch));

        private sealed class ClosedForm : IRuleUse<bool>
        {
            private readonly BodyDescription _body;
            private readonly StretchPlan _stretch;

            public ClosedForm(BodyDescription body, StretchPlan stretch)
            {
                _body = body;
                _stretch = stretch;
            }

            public bool With<TIntegrator>() where TIntegrator : struct, IIntegrator
            {
                TIntegrator rule = default(TIntegrator);
                rule.Start(new Beginning(_body));
                rule.Prepare(1, _stretch.Coasting);
                return rule.HasClosedForm;
            }
        }

        private sealed class MoverMaker : IRuleUse<LoneMover>
        {
            private readonly BodyPlan _plan;
            private readonly Clock _clock;

            public MoverMaker(BodyPlan plan, Clock clock)
            {
                _plan = plan;
                _clock = clock;
            }

            public LoneMover With<TIntegrator>() where TIntegrator : struct, IIntegrator => new Mover<TIntegrator>(_plan, _clock);
        }
    }

    /// <summary>Something to be done with a rule as a type.</summary>
    internal interface IRuleUse<TResult>
    {
        TResult With<TIntegrator>() where TIntegrator : struct, IIntegrator;
    }

    /// <summary>A rule that is the struct <typeparamref name="TIntegrator"/>.</summary>
    internal sealed class RuleOf<TIntegrator> : Rule where TIntegrator : struct, IIntegrator
    {
        public RuleOf(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) => use.With<TIntegrator>();
    }

    /// <summary>A rule that follows the lab's sheet, but for what a body asks to be otherwise.</summary>
    internal sealed class LabRule<TIntegrator> : Rule where TIntegrator : struct, IIntegrator
    {
        public LabRule(string name, string about) : base(name, 1, Keeps.AngularVelocity, Cost.LikeTheLab, about) { }

        internal override string Settings(BodyDescription body) => body.Lab.FirstOrderOrientation ? null : "turned by the whole angle ω Δt";

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) => use.With<TIntegrator>();
    }

    /// <summary>The rule that is chosen by the body's own precision.</summary>
    internal sealed class UnityRule : Rule
    {
        public UnityRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override string Rotation(BodyDescription body) =>
            body.Unity.GyroscopicForces ? "rotation by PhysX's rule with its gyroscopic switch" : base.Rotation(body);

        internal override string Settings(BodyDescription body) => string.Format(
            CultureInfo.InvariantCulture,
            "drag {0} /s, angularDrag {1} /s, limit {2} rad/s, sleep below {3} J/kg of the velocity summed over 0.2 s{4}",
            Guard.AsGiven(body.Unity.Drag), Guard.AsGiven(body.Unity.AngularDrag), Guard.AsGiven(body.Unity.MaxAngularVelocity), Guard.AsGiven(body.Unity.SleepThreshold),
            body.Unity.FirstOrderOrientation ? ", turned by q + [0, ½Δt ω] q" : string.Empty);

        // a force wakes it
        internal override bool CoastsUnderForces => false;

        internal override bool HoldsAxes => true;

        // it sleeps after a while, and that is not known before
        internal override bool Coasts(BodyDescription body, StretchPlan stretch) => false;

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) =>
            body.Unity.InDouble ? use.With<UnityRigidbody<ToDouble>>() : use.With<UnityRigidbody<ToSingle>>();
    }

    /// <summary>The rule whose free rotation is split.</summary>
    internal sealed class SplittingRule : Rule
    {
        public SplittingRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override string Rotation(BodyDescription body) => "free rotation, split into three (order 2)";

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) =>
            !body.CanTurn ? use.With<Composition<HeldTop, Order2>>()
            // ω of a body with locked axes stays: nothing to split
            : (body.Lock & Locks.Turn) != 0 ? use.With<Composition<SphericalTop, Order2>>() : use.With<Composition<SplitTop, Order2>>();
    }

    /// <summary>A rule whose free rotation is chosen by the body's moments: each body pays for what it is.</summary>
    internal sealed class CompositionRule<TScheme> : Rule where TScheme : struct, IScheme
    {
        public CompositionRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) =>
            FreeTops.Choose(body, new WithTop<TResult>(use));

        internal override string Rotation(BodyDescription body) => "free rotation of " + FreeTops.Choose(body, new FreeTops.Words()) + " (exact)";

        internal override string Simpler(BodyDescription body)
        {
            Vector3d i = body.Mass.PrincipalMoments;
            return body.Mass.IsIsotropic ? "all moments are equal, so ω stays"
                : i.X == i.Y || i.Y == i.Z || i.Z == i.X ? "two moments are equal, so two turns are enough" : null;
        }

        private sealed class WithTop<TResult> : FreeTops.IUse<TResult>
        {
            private readonly IRuleUse<TResult> _use;

            public WithTop(IRuleUse<TResult> use) => _use = use;

            public TResult With<TTop>() where TTop : struct, IFreeTop => _use.With<Composition<TTop, TScheme>>();
        }
    }
}
