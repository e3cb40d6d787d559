namespace RigidBodyDynamics
{
    /// <summary>Damps the rotation: L' = −c L, so ω falls by exp(−c h) in a time h, in steps of any length.</summary>
    public readonly struct AngularDamping : ICoast
    {
        private readonly double _rate;

        /// <summary>Damping at the given rate c, 1/s.</summary>
        public AngularDamping(double rate) => _rate = Guard.NotNegative(rate, "angularDamping");

        public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsAngularVelocity | EffectTraits.IsDamping;

        public void AddTo(ref Coasting coasting, MassProperties mass) => coasting.AngularDampingRate += _rate;

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "angular damping " + _rate.ToString("R", System.Globalization.CultureInfo.InvariantCulture) + " /s";
    }
}
