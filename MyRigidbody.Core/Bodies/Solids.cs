namespace RigidBodyDynamics
{
    /// <summary>Homogeneous solids about their centre, axes along the body axes. Lengths in m, masses in kg.</summary>
    /// <remarks>Moments as in any table, for instance Goldstein, Classical Mechanics, chapter 5.</remarks>
    public static partial class Solids
    {
        /// <summary>A box with the given full edges: I_x = m (b² + c²) / 12, as for Unity's box collider.</summary>
        public static MassProperties Box(double mass, Vector3d edges)
        {
            Guard.Positive(edges, nameof(edges));
            Vector3d square = Vector3d.Scale(edges, edges);
            return Principal(mass, Guard.Positive(mass, nameof(mass)) / 12 * OthersSum(square));
        }

        /// <summary>A ball: 2/5 m r² about every axis.</summary>
        public static MassProperties Sphere(double mass, double radius)
        {
            Guard.Positive(radius, nameof(radius));
            double moment = 0.4 * Guard.Positive(mass, nameof(mass)) * radius * radius;
            return Principal(mass, new Vector3d(moment, moment, moment));
        }

        /// <summary>A cylinder: m r² / 2 along, m (3 r² + h²) / 12 across.</summary>
        /// <param name="mass">kg.</param>
        /// <param name="radius">m.</param>
        /// <param name="height">m.</param>
        /// <param name="axis">The body axis of the cylinder: 0 is x, 1 y, as Unity's, and 2 z.</param>
        public static MassProperties Cylinder(double mass, double radius, double height, int axis = 1)
        {
            Guard.Positive(mass, nameof(mass));
            double along = 0.5 * Guard.Positive(radius, nameof(radius)) * radius;
            double across = 0.5 * along + Guard.Positive(height, nameof(height)) * height / 12;
            return Principal(mass, Along(axis, mass * along, mass * across));
        }

        /// <summary>A capsule: a cylinder of the given height between two half balls.</summary>
        /// <param name="mass">kg.</param>
        /// <param name="radius">m.</param>
        /// <param name="height">Of the cylinder, m.</param>
        /// <param name="axis">The body axis of the capsule: 0 is x, 1 y, as Unity's, and 2 z.</param>
        /// <remarks>
        /// The centre of a half ball is 3/8 r from its flat side; about that centre its moments are 2/5 m r² along the axis and
        /// (2/5 − 9/64) m r² across. Masses are in proportion to volumes: r² h to 4/3 r³.
        /// </remarks>
        public static MassProperties Capsule(double mass, double radius, double height, int axis = 1)
        {
            Guard.Positive(mass, nameof(mass));
            Guard.Positive(radius, nameof(radius));
            Guard.Positive(height, nameof(height));
            double rr = radius * radius;
            double balls = mass * (4 * radius) / (4 * radius + 3 * height), cylinder = mass - balls;
            double out8 = 0.5 * height + 0.375 * radius;
            double along = cylinder * 0.5 * rr + balls * 0.4 * rr;
            double across = cylinder * (0.25 * rr + height * height / 12) + balls * ((0.4 - 9.0 / 64) * rr + out8 * out8);
            return Principal(mass, Along(axis, along, across));
        }

        private static Vector3d Along(int axis, double along, double across) =>
            axis == 0 ? new Vector3d(along, across, across)
            : axis == 1 ? new Vector3d(across, along, across)
            : axis == 2 ? new Vector3d(across, across, along)
            : throw Guard.Refused(nameof(axis), axis, "must be 0 for x, 1 for y or 2 for z");

        private static MassProperties Principal(double mass, Vector3d moments) => MassProperties.FromPrincipal(mass, moments);

        private static Vector3d OthersSum(Vector3d a) => new Vector3d(a.Y + a.Z, a.X + a.Z, a.X + a.Y);
    }
}
