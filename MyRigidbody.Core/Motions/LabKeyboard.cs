namespace RigidBodyDynamics
{
    /// <summary>The lab's keys that are held, as the program sets them between steps. Keep a reference to change it.</summary>
    public sealed class LabKeyboard
    {
        private readonly bool[] _held = new bool[HeldKeys.Count];

        /// <summary>True while a key is held.</summary>
        public bool this[LabKey key]
        {
            get => _held[Checked(key)];
            set => _held[Checked(key)] = value;
        }

        internal bool Holds(int key) => _held[key];

        private static int Checked(LabKey key) =>
            key >= 0 && (int)key < HeldKeys.Count ? (int)key : throw Guard.Refused(nameof(key), key, "must be one of the lab's keys");
    }

    /// <summary>The effect of a <see cref="LabKeyboard"/>: <c>body.With(new HeldKeys(keyboard))</c>.</summary>
    public readonly struct HeldKeys : IInput
    {
        internal const int Count = (int)LabKey.R + 1;
        private static readonly KeyPush[] Keys = MakeKeys();
        private readonly LabKeyboard _keyboard;

        /// <summary>The effect of the keys that are held.</summary>
        public HeldKeys(LabKeyboard keyboard) => _keyboard = Guard.NotNull(keyboard, nameof(keyboard));

        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsTime;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            // default(HeldKeys) has no keyboard
            for (int key = 0; key < Count && _keyboard != null; key++)
            {
                if (_keyboard.Holds(key))
                    Keys[key].At(now, body, mass, ref wrench);
            }
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            for (int key = 0; key < Count && _keyboard != null; key++)
            {
                if (_keyboard.Holds(key))
                    Keys[key].Over(now, duration, body, mass, ref impulse);
            }
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "keys held on the keyboard";

        private static KeyPush[] MakeKeys()
        {
            KeyPush[] keys = new KeyPush[Count];
            for (int key = 0; key < Count; key++)
                keys[key] = new KeyPush((LabKey)key);

            return keys;
        }
    }

    /// <summary>A push that a program may change between one call and the next.</summary>
    internal interface IInput : IPush { }
}
