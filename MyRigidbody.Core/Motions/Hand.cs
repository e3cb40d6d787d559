namespace RigidBodyDynamics
{
    /// <summary>What a program pushes with, set between steps: keys, a thruster, a player. Keep it to change it.</summary>
    public sealed class Hand
    {
        private Vector3d _force;
        private Vector3d _torque;

        /// <summary>Force at the centre of mass, N, world axes.</summary>
        public Vector3d Force { get => _force; set => _force = Guard.Finite(value, nameof(Force)); }

        /// <summary>Torque, N m, world axes.</summary>
        public Vector3d Torque { get => _torque; set => _torque = Guard.Finite(value, nameof(Torque)); }
    }

    /// <summary>The effect of a <see cref="Hand"/>: <c>body.With(new HeldBy(hand))</c>.</summary>
    public readonly struct HeldBy : IInput
    {
        private readonly Hand _hand;

        /// <summary>The effect of a hand.</summary>
        public HeldBy(Hand hand) => _hand = Guard.NotNull(hand, nameof(hand));

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            // default(HeldBy) is nobody's
            if (_hand == null)
                return;

            impulse.Force += duration * _hand.Force;
            impulse.Torque += duration * _hand.Torque;
        }

        /// <summary>In words.</summary>
        public override string ToString() => "what the program pushes with";
    }

    /// <summary>A push that a program may change between one call and the next.</summary>
    internal interface IInput : IPush { }
}
