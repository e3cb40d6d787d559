using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The catalogue of integrators. Command line, tests, tables and menus all read it; a new integrator is one struct
    /// in a file of its own and one line here. Your own needs no line: <see cref="Of{TIntegrator}"/>.
    /// </summary>
    public static class Rules
    {
        private const Keeps Kept = Keeps.Motion | Keeps.MomentumLength | Keeps.Momentum;

        // in the order of the initialisers below, which add to it
        private static readonly List<Rule> List = new List<Rule>();

        /// <summary>Formula 3.3 as printed.</summary>
        public static Rule ExplicitEuler { get; } = Listed(new LabRule<ExplicitEuler>(
            "ExplicitEuler", "formula 3.3 as printed: x moves on with the old velocity"));

        /// <summary>The lab's own.</summary>
        public static Rule LabEuler { get; } = Listed(new LabRule<LabEuler>(
            "LabEuler", "the lab's five steps, in the order of its script"));

        /// <summary>Unity's own body.</summary>
        public static Rule UnityRigidbody { get; } = Listed(new UnityRule(
            "UnityRigidbody", 1, Keeps.AngularVelocity, Cost.SeveralTimesTheLab, "DefaultRigidbody: PhysX's integrator with drag, 7 rad/s and sleep"));

        /// <summary>A reference: implicit Euler for ω.</summary>
        public static Rule ImplicitGyroscopic { get; } = Listed<GyroscopicEuler<ImplicitRule>>(
            "ImplicitGyroscopic", 1, Keeps.Motion, Cost.SeveralTimesTheLab, "for comparison: one Newton step for the gyroscopic torque, as in popular engines");

        /// <summary>A reference: explicit Euler for L.</summary>
        public static Rule ExplicitGyroscopic { get; } = Listed<GyroscopicEuler<ExplicitRule>>(
            "ExplicitGyroscopic", 1, Keeps.Motion | Keeps.MomentumLength, Cost.SeveralTimesTheLab, "for comparison: angular momentum scaled back to its length, as by PhysX's option");

        /// <summary>Free rotation split into five rotations.</summary>
        public static Rule Splitting { get; } = Listed(new SplittingRule(
            "Splitting", 2, Kept | Keeps.EnergyBounded | Keeps.WayBack, Cost.SeveralTimesTheLab, "rotations about the three axes one after another; keeps L, energy oscillates"));

        /// <summary>For pushes that have no exact flow.</summary>
        public static Rule RungeKutta4 { get; } = Listed<RungeKutta4>(
            "RungeKutta4", 4, Kept, Cost.SeveralTimesTheLab, "the classical method, L in world axes; for pushes without an exact flow");

        /// <summary>Exact free motion between half pushes.</summary>
        public static Rule Exact { get; } = Listed(new CompositionRule<Order2>(
            "Exact", 2, Kept | Keeps.Energy | Keeps.WayBack, Cost.LikeTheLab, "exact free motion between half pushes; exact where nothing pushes"));

        /// <summary>The same with order 4.</summary>
        public static Rule Exact4 { get; } = Listed(new CompositionRule<Order4>(
            "Exact4", 4, Kept | Keeps.Energy | Keeps.WayBack, Cost.SeveralTimesTheLab, "the same with seven pushes in a step, twelve where one reads a velocity"));

        /// <summary>The same with order 6.</summary>
        public static Rule Exact6 { get; } = Listed(new CompositionRule<Order6>(
            "Exact6", 6, Kept | Keeps.Energy | Keeps.WayBack, Cost.SeveralTimesTheLab, "the same with twelve pushes in a step, twenty where one reads a velocity"));

        /// <summary>All of them, in the order of the catalogue.</summary>
        public static IReadOnlyList<Rule> All => List;

        /// <summary>The integrator of a body that names none.</summary>
        public static Rule Default => Exact;

        /// <summary>The integrator with a name, exactly as written in the catalogue: for names in text.</summary>
        public static Rule Named(string name)
        {
            List<string> names = new List<string>();
            foreach (Rule rule in All)
            {
                if (rule.Name == name)
                    return rule;

                names.Add(rule.Name);
            }

            throw Guard.Refused("integrator", name, "must be one of " + string.Join(", ", names));
        }

        /// <summary>An integrator of your own, for <see cref="BodyDescription.Rule"/>. Its properties are not verified.</summary>
        /// <typeparam name="TIntegrator">A struct that holds all it stores of one body.</typeparam>
        /// <param name="name">What messages and <c>explain</c> call it; the struct's name if absent.</param>
        /// <param name="order">The power of the step length with which its error falls, at least 1.</param>
        /// <param name="keeps">What it conserves of a body that rotates freely.</param>
        /// <param name="about">One line about it.</param>
        public static Rule Of<TIntegrator>(string name = null, int order = 1, Keeps keeps = Keeps.Motion, string about = "")
            where TIntegrator : struct, IIntegrator =>
            new RuleOf<TIntegrator>(name ?? typeof(TIntegrator).Name, order, keeps, Cost.SeveralTimesTheLab, about);

        private static Rule Listed<TIntegrator>(string name, int order, Keeps keeps, Cost cost, string about)
            where TIntegrator : struct, IIntegrator => Listed(new RuleOf<TIntegrator>(name, order, keeps, cost, about));

        private static Rule Listed(Rule rule)
        {
            List.Add(rule);
            return rule;
        }
    }
}
