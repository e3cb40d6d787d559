namespace RigidBodyDynamics
{
    /// <summary>
    /// Force and torque at an instant (N, N m), or their impulses over a time (N s, N m s). Torques are about the
    /// centre of mass.
    /// </summary>
    public struct Wrench
    {
        /// <summary>Force in world axes.</summary>
        public Vector3d Force;

        /// <summary>Torque in world axes.</summary>
        public Vector3d Torque;

        /// <summary>Torque in body axes, in addition to the one in world axes: integrators that work in body axes use it without a rotation.</summary>
        public Vector3d BodyTorque;

        /// <summary>True if no number in it is infinite or NaN.</summary>
        public bool IsFinite => Force.IsFinite && Torque.IsFinite && BodyTorque.IsFinite;

        /// <summary>The whole torque in world axes.</summary>
        public Vector3d TorqueInWorld(Quaterniond orientation) =>
            BodyTorque.IsZero ? Torque : Torque + orientation.Rotate(BodyTorque);

        /// <summary>The sum of two.</summary>
        internal Wrench With(in Wrench more) =>
            new Wrench { Force = Force + more.Force, Torque = Torque + more.Torque, BodyTorque = BodyTorque + more.BodyTorque };

        /// <summary>A part or a multiple.</summary>
        internal Wrench Times(double factor) =>
            new Wrench { Force = factor * Force, Torque = factor * Torque, BodyTorque = factor * BodyTorque };

        /// <summary>The state of a body after this as an impulse: the same pose, with v + F / m and ω + I⁻¹ τ.</summary>
        public BodyState AppliedTo(BodyState body, MassProperties mass)
        {
            Quaterniond principal = (body.Orientation * Guard.NotNull(mass, nameof(mass)).PrincipalFrame).Normalized;
            body.Velocity += mass.InverseMass * Force;
            body.AngularVelocity += principal.Rotate(Vector3d.Scale(mass.InversePrincipalMoments, principal.RotateInverse(TorqueInWorld(body.Orientation))));
            return body;
        }
    }
}
