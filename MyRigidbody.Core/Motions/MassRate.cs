using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The mass grows or falls at a constant rate, and the moments in proportion, about the same centre. What leaves or comes gives no force of
    /// its own: a rocket's is a <see cref="Force"/> beside it.
    /// </summary>
    public readonly struct MassRate : IEffect
    {
        /// <summary>The rate, kg/s; below zero where mass is lost.</summary>
        /// <param name="rate">kg/s.</param>
        /// <param name="keeps">What goes on: velocities, or momentum and angular momentum.</param>
        public MassRate(double rate, Keeping keeps = Keeping.Velocity)
        {
            Rate = Guard.Finite(rate, nameof(rate));
            Keeps = keeps == Keeping.Velocity || keeps == Keeping.Momentum ? keeps : throw Guard.Refused(nameof(keeps), keeps, "must be velocity or momentum");
        }

        /// <summary>kg/s.</summary>
        public double Rate { get; }

        /// <summary>What goes on.</summary>
        public Keeping Keeps { get; }

        public EffectTraits Traits => Keeps == Keeping.Velocity ? EffectTraits.None
            : EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsTime | EffectTraits.ReadsOrientation | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

        /// <summary>In words.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture, "mass {0:R} kg/s, {1} kept", Rate, Keeps == Keeping.Velocity ? "velocity" : "momentum");
    }
}
