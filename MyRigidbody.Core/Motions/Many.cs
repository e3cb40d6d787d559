namespace RigidBodyDynamics
{
    /// <summary>
    /// Any number of pushes behind their interface: for bodies with more of them than are worth a type of their own.
    /// Each costs two virtual calls.
    /// </summary>
    public struct Many : IPush
    {
        private readonly IPush[] _pushes;

        /// <summary>The sum of the pushes, in their order.</summary>
        public Many(IPush[] pushes)
        {
            _pushes = Guard.NotNull(pushes, nameof(pushes));
            PushTraits traits = PushTraits.None;
            foreach (IPush push in pushes)
                traits |= push.Traits;

            Traits = traits;
        }

        public PushTraits Traits { get; }

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            for (int i = 0; i < _pushes.Length; i++)
                _pushes[i].At(now, body, mass, ref wrench);
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            for (int i = 0; i < _pushes.Length; i++)
                _pushes[now.IsReversed ? _pushes.Length - 1 - i : i].Over(now, duration, body, mass, ref impulse);
        }
    }
}
