using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The mass changes at a constant rate, and the moments in proportion, about the same centre. Mass that leaves or arrives gives no force
    /// by itself: a rocket's thrust is a <see cref="Force"/> beside it.
    /// </summary>
    public readonly struct MassRate : IEffect
    {
        /// <summary>The rate, kg/s; below zero where mass is lost.</summary>
        /// <param name="rate">kg/s.</param>
        /// <param name="keeps">What is conserved: velocities, or momentum and angular momentum.</param>
        public MassRate(double rate, Keeping keeps = Keeping.Velocity)
        {
            Rate = Guard.Finite(rate, nameof(rate));
            Keeps = keeps == Keeping.Velocity || keeps == Keeping.Momentum ? keeps : throw Guard.Refused(nameof(keeps), keeps, "must be velocity or momentum");
        }

        /// <summary>kg/s.</summary>
        public double Rate { get; }

        /// <summary>What is conserved.</summary>
        public Keeping Keeps { get; }

        public EffectTraits Traits => Keeps == Keeping.Velocity ? EffectTraits.None
            : EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsTime | EffectTraits.ReadsOrientation | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture, "mass {0:R} kg/s, {1} kept", Rate, Keeps == Keeping.Velocity ? "velocity" : "momentum");
    }
}
