namespace RigidBodyDynamics
{
    /// <summary>
    /// Any number of pushes behind their interface: for bodies with too many for a type of their own. Each costs two virtual calls.
    /// </summary>
    internal struct Many : IPush
    {
        private readonly IPush[] _pushes;

        /// <summary>The sum of the pushes, in their order.</summary>
        public Many(IPush[] pushes)
        {
            _pushes = Guard.NotNull(pushes, nameof(pushes));
            EffectTraits traits = default(Nothing).Traits;
            for (int i = 0; i < pushes.Length; i++)
                traits = traits.And((pushes[i] ?? throw new System.ArgumentNullException(nameof(pushes) + "[" + i + "]")).Traits);

            Traits = traits;
        }

        public EffectTraits Traits { get; }

        // default(Many) has no pushes
        private int Count => _pushes == null ? 0 : _pushes.Length;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            for (int i = 0; i < Count; i++)
                _pushes[i].At(now, body, mass, ref wrench);
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            for (int i = 0; i < Count; i++)
                _pushes[now.IsReversed ? Count - 1 - i : i].Over(now, duration, body, mass, ref impulse);
        }
    }
}
