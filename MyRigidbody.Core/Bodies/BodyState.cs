namespace RigidBodyDynamics
{
    /// <summary>Where a body is and how it moves, at one instant. World axes, SI units.</summary>
    /// <remarks>
    /// Scenes, effects, integrators and programs exchange states in this form. What an integrator stores between steps is its own
    /// choice: Unity's stores float, the exact one principal axes.
    /// </remarks>
    public struct BodyState
    {
        /// <summary>Position of the origin of the body frame, m. Unity's <c>transform.position</c>.</summary>
        public Vector3d Position;

        /// <summary>Takes body axes to world axes; of length 1 (start values are scaled to it).</summary>
        public Quaterniond Orientation;

        /// <summary>Velocity of the centre of mass, m/s.</summary>
        public Vector3d Velocity;

        /// <summary>Angular velocity, rad/s, in world axes.</summary>
        public Vector3d AngularVelocity;

        /// <summary>The state with the given parts.</summary>
        public BodyState(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d angularVelocity)
        {
            Position = position;
            Orientation = orientation;
            Velocity = velocity;
            AngularVelocity = angularVelocity;
        }

        /// <summary>At the origin, not rotated, at rest.</summary>
        public static BodyState AtRest => new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);

        /// <summary>True if every number in it is finite.</summary>
        public bool IsFinite => Position.IsFinite && Orientation.IsFinite && Velocity.IsFinite && AngularVelocity.IsFinite;

        /// <summary>
        /// False where a number is not finite, or a velocity is so large that its square, which every energy contains, is not: the
        /// integration of such a body has diverged.
        /// </summary>
        public bool HasFiniteSquares =>
            // zero times a finite number is zero, else NaN: one comparison for all
            0 * Position.X + 0 * Position.Y + 0 * Position.Z + 0 * Orientation.W + 0 * Orientation.X + 0 * Orientation.Y + 0 * Orientation.Z
            + 0 * (Velocity.X * Velocity.X + Velocity.Y * Velocity.Y + Velocity.Z * Velocity.Z
            + (AngularVelocity.X * AngularVelocity.X + AngularVelocity.Y * AngularVelocity.Y + AngularVelocity.Z * AngularVelocity.Z)) == 0;

        /// <summary>
        /// A state between two others: the centre of mass by Hermite's cubic through both velocities, the orientation along the shorter
        /// arc at a constant rate, velocities by linear interpolation.
        /// </summary>
        /// <param name="from">The first.</param>
        /// <param name="to">The second.</param>
        /// <param name="center">Centre of mass in the body frame, m.</param>
        /// <param name="duration">From the first to the second, s.</param>
        /// <param name="part">The part of it, 0 to 1.</param>
        internal static BodyState Between(in BodyState from, in BodyState to, Vector3d center, double duration, double part)
        {
            double s = part, r = 1 - part;
            BodyState at = default(BodyState);
            at.Orientation = Quaterniond.Slerp(from.Orientation, to.Orientation, s);
            at.Velocity = r * from.Velocity + s * to.Velocity;
            at.AngularVelocity = r * from.AngularVelocity + s * to.AngularVelocity;
            Vector3d first = from.Position + from.Orientation.Rotate(center), second = to.Position + to.Orientation.Rotate(center);
            Vector3d x = r * r * (1 + 2 * s) * first + s * s * (1 + 2 * r) * second
                + duration * s * r * (r * from.Velocity - s * to.Velocity);
            at.Position = x - at.Orientation.Rotate(center);
            return at;
        }

        /// <summary>All numbers, with all digits.</summary>
        public override string ToString() =>
            "position " + Position + ", orientation " + Orientation + ", velocity " + Velocity + ", angular velocity " + AngularVelocity;
    }
}
