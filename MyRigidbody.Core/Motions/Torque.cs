namespace RigidBodyDynamics
{
    /// <summary>A torque constant + sine · sin(rate t) + cosine · cos(rate t), in world or in body axes.</summary>
    public readonly struct Torque : IPush
    {
        private readonly Harmonic _torque;
        private readonly bool _inBody;

        /// <summary>The torque, N m, with rate in rad/s.</summary>
        /// <param name="constant">The constant part, N m.</param>
        /// <param name="sine">Factor of sin(rate t), N m.</param>
        /// <param name="cosine">Factor of cos(rate t), N m.</param>
        /// <param name="rate">rad/s.</param>
        /// <param name="inBody">True: along body axes, rotating with the body. False: along world axes.</param>
        public Torque(Vector3d constant, Vector3d sine, Vector3d cosine, double rate, bool inBody)
        {
            _torque = new Harmonic(constant, sine, cosine, rate);
            _inBody = inBody;
        }

        /// <summary>A constant torque along world axes, N m.</summary>
        public static Torque Constant(Vector3d torque) => new Torque(torque, Vector3d.Zero, Vector3d.Zero, 0, false);

        public EffectTraits Traits => _torque.Swings ? EffectTraits.Turns | EffectTraits.ReadsTime : EffectTraits.Turns;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            _torque.Add(now.Time, 0, 1, ref _inBody ? ref wrench.BodyTorque : ref wrench.Torque);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            _torque.Add(now.Time, now.IsHeld ? 0 : duration, duration, ref _inBody ? ref impulse.BodyTorque : ref impulse.Torque);

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "torque " + _torque + " N m, " + (_inBody ? "body axes" : "world axes");
    }
}
