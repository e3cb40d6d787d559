using System;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>The state and settings of a body in the engine, in the engine's own floats.</summary>
    internal struct EngineBody
    {
        /// <summary>Takes body axes to world axes.</summary>
        public Quaterniond Orientation;

        /// <summary>rad/s, world axes.</summary>
        public Vector3d AngularVelocity;

        /// <summary>Of the centre of mass, m/s.</summary>
        public Vector3d Velocity;

        /// <summary>kg.</summary>
        public double Mass;

        /// <summary>Moments about the principal axes, kg m²; 0 about an axis that is frozen.</summary>
        public Vector3d InertiaTensor;

        /// <summary>Takes principal axes to body axes.</summary>
        public Quaterniond InertiaTensorRotation;

        /// <summary>1/s: the engine multiplies the angular velocity by 1 − c Δt before it rotates the body.</summary>
        public double AngularDrag;

        /// <summary>Kinetic energy per kg, J/kg, below which the engine lets the body fall asleep.</summary>
        public double SleepThreshold;

        /// <summary>True if the engine does not move it.</summary>
        public bool IsAsleep;

        /// <summary>True if the free top is the same.</summary>
        public bool IsLike(in EngineBody other) =>
            InertiaTensor == other.InertiaTensor && InertiaTensorRotation == other.InertiaTensorRotation && AngularDrag == other.AngularDrag;

        /// <summary>Its mass and inertia.</summary>
        /// <param name="frozen">The locked principal axes.</param>
        /// <exception cref="ArgumentException">No body has such moments.</exception>
        public MassProperties MassProperties(out Locks frozen)
        {
            Vector3d moments = UnitySettings.Moments(InertiaTensor, out frozen);
            return RigidBodyDynamics.MassProperties.FromPrincipal(1, Possible(moments), InertiaTensorRotation, Vector3d.Zero);
        }

        /// <summary>The engine's largest moment of a thin plate may exceed the sum of the others by a rounding.</summary>
        private static Vector3d Possible(Vector3d moments)
        {
            const double rounding = 1e-5;
            double largest = Math.Max(moments.X, Math.Max(moments.Y, moments.Z)), others = moments.X + moments.Y + moments.Z - largest;
            return largest <= (1 + rounding) * others ? RigidBodyDynamics.MassProperties.NearestPossible(moments, moments) : moments;
        }
    }
}
