namespace RigidBodyDynamics
{
    /// <summary>The same acceleration for every body, whatever its mass.</summary>
    public readonly struct Gravity : ICoast
    {
        private readonly Vector3d _acceleration;

        /// <summary>Gravity of the given acceleration, m/s², world axes.</summary>
        public Gravity(Vector3d acceleration) => _acceleration = Guard.Finite(acceleration, "gravity");

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.HasPotential | EffectTraits.IsGravity;

        public void AddTo(ref Coasting coasting, MassProperties mass) => coasting.Acceleration += _acceleration;

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "gravity (" + Guard.AsGiven(_acceleration.X) + ", " + Guard.AsGiven(_acceleration.Y) + ", " + Guard.AsGiven(_acceleration.Z) + ") m/s²";
    }
}
