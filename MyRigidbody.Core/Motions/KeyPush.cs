namespace RigidBodyDynamics
{
    /// <summary>The keys of the lab.</summary>
    public enum LabKey
    {
        /// <summary>5 N along −x.</summary>
        LeftArrow,

        /// <summary>5 N along +x.</summary>
        RightArrow,

        /// <summary>5 N along +y.</summary>
        UpArrow,

        /// <summary>5 N along −y.</summary>
        DownArrow,

        /// <summary>Torque (sin t, sin t, sin t) N m, t the time since the start of the scene.</summary>
        R,
    }

    /// <summary>A key of the lab that is held down.</summary>
    public readonly struct KeyPush : IPush
    {
        private const double Push = 5;
        private static readonly Vector3d Ones = new Vector3d(1, 1, 1);
        private readonly LabKey _key;
        private readonly Vector3d _force;
        private readonly Torque _torque;

        /// <summary>The effect of a key.</summary>
        public KeyPush(LabKey key)
        {
            _key = key;
            _force = Vector3d.Zero;
            _torque = default(Torque);
            switch (key)
            {
                case LabKey.LeftArrow: _force = new Vector3d(-Push, 0, 0); break;
                case LabKey.RightArrow: _force = new Vector3d(Push, 0, 0); break;
                case LabKey.UpArrow: _force = new Vector3d(0, Push, 0); break;
                case LabKey.DownArrow: _force = new Vector3d(0, -Push, 0); break;
                case LabKey.R: _torque = new Torque(Vector3d.Zero, Ones, Vector3d.Zero, 1, inBody: false); break;
                default: throw Guard.Refused("key", key, "must be one of the lab's keys");
            }
        }

        public EffectTraits Traits => _key == LabKey.R ? _torque.Traits : EffectTraits.Moves | EffectTraits.HasPotential;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            if (_key == LabKey.R)
                _torque.At(now, body, mass, ref wrench);
            else
                _force.AddTo(ref wrench.Force, 1);
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (_key == LabKey.R)
                _torque.Over(now, duration, body, mass, ref impulse);
            else
                _force.AddTo(ref impulse.Force, duration);
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "key " + _key;
    }
}
