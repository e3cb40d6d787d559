using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The one list of integrators. Command line, tests, tables and menus all read it; a new integrator is one struct
    /// in a file of its own and one line here.
    /// </summary>
    public static class Catalogue
    {
        private const Keeps Kept = Keeps.Motion | Keeps.MomentumLength | Keeps.Momentum;

        /// <summary>All of them, from the lab's own rule on.</summary>
        public static IReadOnlyList<CatalogueRow> Rows { get; } = new CatalogueRow[]
        {
            new CatalogueRow<ExplicitEuler>(
                "ExplicitEuler", 1, Keeps.AngularVelocity, Cost.LikeTheLab, "formula 3.3 as printed: x moves on with the old velocity"),
            new CatalogueRow<LabEuler>(
                "LabEuler", 1, Keeps.AngularVelocity, Cost.LikeTheLab, "the lab's five steps, in the order of its script"),
            new UnityRow(
                "UnityRigidbody", 1, Keeps.AngularVelocity, Cost.SeveralTimesTheLab, "DefaultRigidbody: PhysX's rule with drag, 7 rad/s and sleep"),
            new CatalogueRow<GyroscopicEuler<ImplicitRule>>(
                "ImplicitGyroscopic", 1, Keeps.Motion, Cost.SeveralTimesTheLab, "yardstick: one Newton step for the gyroscopic torque, as popular engines do"),
            new CatalogueRow<GyroscopicEuler<ExplicitRule>>(
                "ExplicitGyroscopic", 1, Keeps.Motion | Keeps.MomentumLength, Cost.SeveralTimesTheLab, "yardstick: momentum back to its old length, as PhysX's switch does"),
            new SplittingRow(
                "Splitting", 2, Kept | Keeps.EnergyBounded | Keeps.WayBack, Cost.SeveralTimesTheLab, "rotations about the three axes in turn; keeps L, energy swings"),
            new CatalogueRow<RungeKutta4>(
                "RungeKutta4", 4, Kept, Cost.SeveralTimesTheLab, "the classical rule, L in world axes; for pushes that cannot be taken apart"),
            new CompositionRow<Order2>(
                "Exact", 2, Kept | Keeps.Energy | Keeps.WayBack, Cost.LikeTheLab, "exact free motion between half pushes; exact where nothing pushes"),
            new CompositionRow<Order4>(
                "Exact4", 4, Kept | Keeps.Energy | Keeps.WayBack, Cost.SeveralTimesTheLab, "the same with seven pushes in a step, twelve where one reads a velocity"),
            new CompositionRow<Order6>(
                "Exact6", 6, Kept | Keeps.Energy | Keeps.WayBack, Cost.SeveralTimesTheLab, "the same with twelve pushes in a step, twenty where one reads a velocity"),
        };

        /// <summary>The row of a body that names none.</summary>
        public static CatalogueRow Default => Find("Exact");

        /// <summary>The row with a name, exactly as it is written in the list.</summary>
        public static CatalogueRow Find(string name)
        {
            foreach (CatalogueRow row in Rows)
            {
                if (row.Name == name)
                    return row;
            }

            throw Guard.Refused("integrator", name, "must be one of " + string.Join(", ", Names()));
        }

        private static IEnumerable<string> Names()
        {
            foreach (CatalogueRow row in Rows)
                yield return row.Name;
        }
    }
}
