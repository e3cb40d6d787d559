using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>What an integrator conserves of a body that rotates freely.</summary>
    [Flags]
    public enum Keeps
    {
        /// <summary>No gyroscopic term: ω is constant, which is another motion where the three moments differ.</summary>
        AngularVelocity = 0,

        /// <summary>It converges to the free motion as the step length falls. For a given step length it need not conserve anything.</summary>
        Motion = 1,

        /// <summary>|L| within rounding.</summary>
        MomentumLength = 2,

        /// <summary>The vector L within rounding.</summary>
        Momentum = 4,

        /// <summary>The energy oscillates within bounds, however long the run.</summary>
        EnergyBounded = 8,

        /// <summary>The energy within rounding, however long the run and the step.</summary>
        Energy = 16,

        /// <summary>Reversible: as many steps with all velocities reversed end at the start, under pushes that read only the pose.</summary>
        WayBack = 32,
    }

    /// <summary>The cost of a step, in steps of the lab.</summary>
    internal enum Cost
    {
        /// <summary>Up to one and a half times the lab's step.</summary>
        LikeTheLab,

        /// <summary>More than that.</summary>
        SeveralTimesTheLab,
    }

    /// <summary>An integrator in the catalogue, with its properties. <see cref="Rules"/> has all of them.</summary>
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

        /// <summary>The name in scenes and commands.</summary>
        public string Name { get; }

        /// <summary>
        /// The error after a given time falls with this power of the step length, where the integrator converges: for every effect
        /// and all of them together, except those that <see cref="OrderFor"/> treats.
        /// </summary>
        public int Order { get; }

        /// <summary>What it conserves of a body that rotates freely.</summary>
        public Keeps Keeps { get; }

        /// <summary>The cost of a step.</summary>
        internal Cost Cost { get; }

        /// <summary>One line about it.</summary>
        public string About { get; }

        /// <summary>
        /// The order for a body. It is <see cref="Order"/>, or 1 for every integrator where velocities are multiplied once a step
        /// (<see cref="DecayPerStep"/>): the factor acts after all other effects, and is compared with the rate that it stands for.
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

        /// <summary>An operation on the integrator's type, the one that suits a body.</summary>
        internal abstract TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use);

        /// <summary>How this integrator computes the rotation of a body, in words.</summary>
        internal virtual string Rotation(BodyDescription body) =>
            "rotation by " + Name + ((Keeps & Keeps.Motion) != 0 ? string.Empty : " (no gyroscopic term)");

        /// <summary>What the integrator does by itself, whatever the scene's effects, in words; null if nothing.</summary>
        internal virtual string Settings(BodyDescription body) => null;

        /// <summary>Why this integrator can compute the rotation of a body more simply than that of any body; null if it cannot.</summary>
        internal virtual string Simpler(BodyDescription body) => null;

        /// <summary>True if the integrator itself implements locked axes; for all others a <see cref="Bearing"/> does.</summary>
        internal virtual bool HoldsAxes => false;

        /// <summary>True if a constant force is a part of coasting for this integrator, and no push.</summary>
        internal virtual bool CoastsUnderForces => true;

        /// <summary>True if this integrator has a closed form for a body during a stretch: the integrator itself says so.</summary>
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
    }

    /// <summary>An operation on an integrator as a type.</summary>
    internal interface IRuleUse<TResult>
    {
        TResult With<TIntegrator>() where TIntegrator : struct, IIntegrator;
    }

    /// <summary>An integrator that is the struct <typeparamref name="TIntegrator"/>.</summary>
    internal sealed class RuleOf<TIntegrator> : Rule where TIntegrator : struct, IIntegrator
    {
        public RuleOf(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) => use.With<TIntegrator>();
    }

    /// <summary>An integrator that follows the lab's sheet, except for the settings of a body.</summary>
    internal sealed class LabRule<TIntegrator> : Rule where TIntegrator : struct, IIntegrator
    {
        public LabRule(string name, string about) : base(name, 1, Keeps.AngularVelocity, Cost.LikeTheLab, about) { }

        internal override string Settings(BodyDescription body) => body.Lab.FirstOrderOrientation ? null : "turned by the whole angle ω Δt";

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) => use.With<TIntegrator>();
    }

    /// <summary>The integrator in the precision that the body's settings choose.</summary>
    internal sealed class UnityRule : Rule
    {
        public UnityRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override string Rotation(BodyDescription body) =>
            body.Unity.GyroscopicForces ? "rotation as in PhysX with its gyroscopic option" : base.Rotation(body);

        internal override string Settings(BodyDescription body) => string.Format(
            CultureInfo.InvariantCulture,
            "drag {0} /s, angularDrag {1} /s, limit {2} rad/s, sleep below {3} J/kg of the velocity summed over 0.2 s{4}",
            Guard.AsGiven(body.Unity.Drag), Guard.AsGiven(body.Unity.AngularDrag), Guard.AsGiven(body.Unity.MaxAngularVelocity), Guard.AsGiven(body.Unity.SleepThreshold),
            body.Unity.FirstOrderOrientation ? ", turned by q + [0, ½Δt ω] q" : string.Empty);

        // a force wakes the body
        internal override bool CoastsUnderForces => false;

        internal override bool HoldsAxes => true;

        // the body falls asleep at a time that is not known in advance
        internal override bool Coasts(BodyDescription body, StretchPlan stretch) => false;

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) =>
            body.Unity.InDouble ? use.With<UnityRigidbody<ToDouble>>() : use.With<UnityRigidbody<ToSingle>>();
    }

    /// <summary>The integrator whose free rotation is split.</summary>
    internal sealed class SplittingRule : Rule
    {
        public SplittingRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override string Rotation(BodyDescription body) => "free rotation, split into three (order 2)";

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use) =>
            !body.CanTurn ? use.With<Composition<HeldTop, Order2>>()
            // ω of a body with locked axes is constant: nothing to split
            : (body.Lock & Locks.Turn) != 0 ? use.With<Composition<SphericalTop, Order2>>() : use.With<Composition<SplitTop, Order2>>();
    }

    /// <summary>An integrator whose free rotation is chosen by the body's moments: the cheapest that is exact.</summary>
    internal sealed class CompositionRule<TScheme> : Rule where TScheme : struct, IScheme
    {
        public CompositionRule(string name, int order, Keeps keeps, Cost cost, string about) : base(name, order, keeps, cost, about) { }

        internal override TResult Use<TResult>(BodyDescription body, IRuleUse<TResult> use)
        {
            int different = DifferentMoments(body.Mass);
            return !body.CanTurn ? use.With<Composition<HeldTop, TScheme>>()
                : different == 1 ? use.With<Composition<SphericalTop, TScheme>>()
                : different == 2 ? use.With<Composition<SymmetricTop, TScheme>>() : use.With<Composition<AsymmetricTop, TScheme>>();
        }

        internal override string Rotation(BodyDescription body)
        {
            int different = DifferentMoments(body.Mass);
            return "free rotation of " + (different == 1 ? "a body with three equal moments"
                : different == 2 ? "a body with two equal moments" : "a body with three different moments") + " (exact)";
        }

        internal override string Simpler(BodyDescription body)
        {
            int different = DifferentMoments(body.Mass);
            return different == 1 ? "all moments are equal, so ω stays" : different == 2 ? "two moments are equal, so two turns are enough" : null;
        }

        private static int DifferentMoments(MassProperties mass)
        {
            Vector3d i = mass.PrincipalMoments;
            return mass.IsIsotropic ? 1 : i.X == i.Y || i.Y == i.Z || i.Z == i.X ? 2 : 3;
        }
    }
}
