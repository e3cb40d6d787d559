using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>Quadratic air drag: force −k abs(v) v.</summary>
    public readonly struct QuadraticDrag : IPush
    {
        private readonly double _k;

        /// <summary>Drag with the given k, kg/m.</summary>
        public QuadraticDrag(double k) => _k = Guard.NotNegative(k, "quadraticDrag");

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsVelocity | EffectTraits.IsDrag;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            wrench.Force -= _k * body.Velocity.Length * body.Velocity;

        /// <remarks>m v' = −k abs(v) v has v = v₀ / (1 + z), z = k abs(v₀) h / m: v never changes its direction.</remarks>
        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            Vector3d v = body.Velocity + mass.InverseMass * impulse.Force;
            double z = _k * v.Length * duration * mass.InverseMass;
            impulse.Force -= mass.Mass * (z / (1 + z)) * v;
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "drag " + _k.ToString("R", CultureInfo.InvariantCulture) + " abs(v) v N";
    }
}
