namespace RigidBodyDynamics
{
    /// <summary>Nothing pushes, over a time that is one closed form however long it is: a rule may take it more exactly than a step.</summary>
    internal struct Leap : IPush
    {
        public EffectTraits Traits => EffectTraits.None;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) { }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) { }
    }
}
