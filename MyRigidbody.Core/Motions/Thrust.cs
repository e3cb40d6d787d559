namespace RigidBodyDynamics
{
    /// <summary>A force that is fixed in the body and turns with it, as a thruster's is.</summary>
    public readonly struct Thrust : IPush
    {
        private readonly Vector3d _force;
        private readonly Vector3d _point;

        /// <summary>The thrust.</summary>
        /// <param name="force">N, body axes.</param>
        /// <param name="point">Where it acts, body frame, m; beside the centre of mass it turns the body.</param>
        public Thrust(Vector3d force, Vector3d point)
        {
            _force = Guard.Finite(force, nameof(force));
            _point = Guard.Finite(point, nameof(point));
        }

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsOrientation;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            impulse.Force += duration * body.Orientation.Rotate(_force);
            impulse.BodyTorque += duration * Vector3d.Cross(_point - mass.CenterOfMass, _force);
        }

        /// <summary>In words.</summary>
        public override string ToString() => "thrust " + _force + " N at " + _point + " m, body axes";
    }
}
