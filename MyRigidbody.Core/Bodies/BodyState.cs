namespace RigidBodyDynamics
{
    /// <summary>Where a body is and how it moves, at one instant. World axes, SI units.</summary>
    /// <remarks>
    /// This is the language in which scenes, effects, integrators and readers speak to each other. What an
    /// integrator keeps between steps is its own business: Unity's keeps float, the exact one principal axes.
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

        /// <summary>At the origin, unturned, at rest.</summary>
        public static BodyState AtRest =>
            new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);

        /// <summary>True if no number in it is infinite or NaN.</summary>
        public bool IsFinite =>
            Position.IsFinite && Orientation.IsFinite && Velocity.IsFinite && AngularVelocity.IsFinite;

        /// <summary>
        /// False where a number is not finite or a velocity is so large that its square, which every energy has, is not: such a body
        /// has run away.
        /// </summary>
        internal bool HasFiniteSquares =>
            Position.IsFinite && Orientation.IsFinite && Guard.IsFinite(Velocity.LengthSquared + AngularVelocity.LengthSquared);

        /// <summary>In words, to the last digit.</summary>
        public override string ToString() =>
            "position " + Position + ", orientation " + Orientation + ", velocity " + Velocity + ", angular velocity " + AngularVelocity;
    }
}
