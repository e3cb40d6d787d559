using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Bodies made of points: the lab's I_ref = Σ m (r·r 1 − r rᵀ), r from the centre of mass.</summary>
    public static class PointMasses
    {
        /// <summary>Points of equal mass, <paramref name="mass"/> in all: the vertices of a mesh, as in the lab.</summary>
        /// <param name="mass">The sum over all points, kg.</param>
        /// <param name="points">In the body frame, m. A point listed three times has three times the mass.</param>
        public static MassProperties Equal(double mass, IReadOnlyList<Vector3d> points)
        {
            Guard.Positive(mass, nameof(mass));
            double[] masses = new double[Guard.NotNull(points, nameof(points)).Count];
            for (int i = 0; i < masses.Length; i++)
                masses[i] = mass / masses.Length;

            return Of(points, masses);
        }

        /// <summary>Points of individual masses. They must not all lie on one line.</summary>
        /// <param name="points">In the body frame, m.</param>
        /// <param name="masses">kg, each above zero.</param>
        public static MassProperties Of(IReadOnlyList<Vector3d> points, IReadOnlyList<double> masses)
        {
            Guard.NotNull(points, nameof(points));
            Guard.NotNull(masses, nameof(masses));
            if (points.Count == 0 || points.Count != masses.Count)
                throw Guard.Refused(nameof(masses), masses.Count, "must be as many as there are points (" + points.Count + "), at least one");

            double mass = 0;
            Vector3d moment = Vector3d.Zero;
            for (int i = 0; i < points.Count; i++)
            {
                Guard.Finite(points[i], nameof(points), i);
                mass += Guard.Positive(masses[i], nameof(masses), i);
                moment += masses[i] * points[i];
            }

            Guard.Positive(mass, "sum of masses");
            Vector3d center = moment / mass;
            SymmetricMatrix3 inertia = default(SymmetricMatrix3);
            for (int i = 0; i < masses.Count; i++)
                inertia += masses[i] * SymmetricMatrix3.OfPoint(points[i] - center);

            return MassProperties.FromTensor(mass, inertia, center);
        }

        /// <summary>The lab's box: an eighth of the mass in each corner. Its moments are three times those of the solid box.</summary>
        public static MassProperties BoxVertices(double mass, Vector3d edges)
        {
            Guard.Positive(edges, nameof(edges));
            Vector3d[] corners = new Vector3d[8];
            for (int i = 0; i < corners.Length; i++)
            {
                Vector3d sides = new Vector3d((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
                corners[i] = Vector3d.Scale(sides, edges);
            }

            return Equal(mass, corners);
        }
    }
}
