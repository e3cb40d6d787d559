namespace RigidBodyDynamics
{
    /// <summary>No push, over a time in one closed form of any length: an integrator may compute it more exactly than a step.</summary>
    internal struct Leap : IPush
    {
        public EffectTraits Traits => EffectTraits.None;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) { }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) { }
    }
}
