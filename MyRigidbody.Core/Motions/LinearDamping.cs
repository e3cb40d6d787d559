namespace RigidBodyDynamics
{
    /// <summary>Damps the velocity: v' = −c v, so v falls by exp(−c h) in a time h, in steps of any length.</summary>
    public readonly struct LinearDamping : ICoast
    {
        private readonly double _rate;

        /// <summary>Damping at the given rate c, 1/s.</summary>
        public LinearDamping(double rate) => _rate = Guard.NotNegative(rate, "linearDamping");

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsVelocity | EffectTraits.IsDamping;

        public void AddTo(ref Coasting coasting, MassProperties mass) => coasting.LinearDampingRate += _rate;

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "linear damping " + _rate.ToString("R", System.Globalization.CultureInfo.InvariantCulture) + " /s";
    }
}
