using System;

namespace RigidBodyDynamics
{
    /// <summary>The quantities by which a motion is judged: energy, momentum, and the angle between two orientations.</summary>
    public static class Conserved
    {
        /// <summary>½ m v² + ½ ω·L, J.</summary>
        public static double KineticEnergy(in BodyState state, MassProperties mass) =>
            0.5 * mass.Mass * state.Velocity.LengthSquared
            + 0.5 * Vector3d.Dot(state.AngularVelocity, AngularMomentum(state, mass));

        /// <summary>
        /// L = R I_ref Rᵀ ω, kg m²/s, in world axes, about the centre of mass. R is the rotation of the orientation scaled to length 1,
        /// because the lab's formula without normalisation lets the length grow.
        /// </summary>
        public static Vector3d AngularMomentum(in BodyState state, MassProperties mass)
        {
            Quaterniond q = state.Orientation.Normalized;
            return q.Rotate(mass.Inertia * q.RotateInverse(state.AngularVelocity));
        }

        /// <summary>p = m v, kg m/s.</summary>
        public static Vector3d Momentum(in BodyState state, MassProperties mass) => mass.Mass * state.Velocity;

        /// <summary>The angle of the rotation from one orientation to the other, rad, 0 to π. Accurate for small angles, too.</summary>
        public static double AngleBetween(Quaterniond a, Quaterniond b)
        {
            Quaterniond d = a.Conjugate * b;
            return 2 * Math.Atan2(d.Vector.Length, Math.Abs(d.W));
        }
    }
}
