using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A constant force at the centre of mass. A body coasts with it as with gravity; by <c>UnityRigidbody</c>, whose sleep knows
    /// forces, it is a push.
    /// </summary>
    public readonly struct Force : IPush, ICoast
    {
        private readonly Vector3d _force;

        /// <summary>The force, N, world axes.</summary>
        public Force(Vector3d force) => _force = Guard.Finite(force, "force");

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.HasPotential;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => wrench.Force += _force;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force += duration * _force;

        public void AddTo(ref Coasting coasting, MassProperties mass) => coasting.Acceleration += _force / mass.Mass;

        /// <summary>In words.</summary>
        public override string ToString() => "force " + _force + " N";
    }
}
