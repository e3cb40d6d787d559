namespace RigidBodyDynamics
{
    internal static class MassChange
    {
        /// <summary>The state of a body after its mass properties have changed.</summary>
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
