namespace RigidBodyDynamics
{
    /// <summary>What goes on where the mass of a body changes. Its frame stays in its place.</summary>
    public enum Keeping
    {
        /// <summary>Every point of the body keeps its velocity: what comes moves with it, what leaves does so at rest to it (fuel).</summary>
        Velocity,

        /// <summary>Momentum, and angular momentum about the centre of mass: what comes had none, what moved did so within the body.</summary>
        Momentum,
    }

    internal static class MassChange
    {
        /// <summary>The state of a body once it has other mass properties.</summary>
        public static BodyState Of(BodyState state, MassProperties from, MassProperties to, Keeping keeping)
        {
            if (keeping == Keeping.Momentum)
            {
                Wrench momentum = new Wrench { Force = Conserved.Momentum(state, from), Torque = Conserved.AngularMomentum(state, from) };
                state.Velocity = state.AngularVelocity = Vector3d.Zero;
                return momentum.AppliedTo(state, to);
            }

            Vector3d shift = state.Orientation.Rotate(to.CenterOfMass - from.CenterOfMass);
            state.Velocity += Vector3d.Cross(state.AngularVelocity, shift);
            return state;
        }
    }
}
