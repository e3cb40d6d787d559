using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>The empty sum of pushes.</summary>
    internal struct Nothing : IPush
    {
        public EffectTraits Traits => EffectTraits.HasPotential;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) { }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) { }
    }
}
