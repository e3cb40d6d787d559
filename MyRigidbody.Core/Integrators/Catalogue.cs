using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The one list of integrators. Command line, tests, tables and menus all read it; a new integrator is one struct
    /// in a file of its own and one line here.
    /// </summary>
    public static class Catalogue
    {
        /// <summary>All of them, from the lab's own rule on.</summary>
        public static IReadOnlyList<CatalogueRow> Rows { get; } = new CatalogueRow[]
        {
            new CatalogueRow<ExplicitEuler>("ExplicitEuler", 1, Cost.LikeTheLab, "formula 3.3 as printed: x moves on with the old velocity"),
            new CatalogueRow<LabEuler>("LabEuler", 1, Cost.LikeTheLab, "the lab's five steps, in the order of its script"),
            new UnityRow("UnityRigidbody", 1, Cost.SeveralTimesTheLab, "DefaultRigidbody: PhysX's rule with drag, 7 rad/s and sleep"),
        };

        /// <summary>The row of a body that names none.</summary>
        public static CatalogueRow Default => Find("LabEuler");

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
