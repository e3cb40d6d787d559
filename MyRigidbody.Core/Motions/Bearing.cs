namespace RigidBodyDynamics
{
    /// <summary>
    /// Takes from what acts on a body what its <see cref="Locks"/> take up, and leaves torques as they turn a body with three equal
    /// moments of 1 kg m² in the same way: its ω stays where nothing turns it, as that of a locked body does. So no rule has to
    /// know of locks, and the exact ones are exact.
    /// </summary>
    internal sealed class Bearing
    {
        private readonly Locks _locks;
        private readonly MassProperties _real;

        private Bearing(Locks locks, MassProperties real)
        {
            _locks = locks;
            _real = real;
            Mass = IsPart(locks & Locks.Turn, Locks.Turn)
                ? MassProperties.FromPrincipal(real.Mass, new Vector3d(1, 1, 1), real.PrincipalFrame, real.CenterOfMass)
                : real;
        }

        /// <summary>What a rule takes the body for.</summary>
        public MassProperties Mass { get; }

        /// <summary>True if torques are seen by the body's axes.</summary>
        public bool ReadsOrientation => Mass != _real;

        /// <summary>Null for a body that is not locked, or whole: a rule then has nothing to do.</summary>
        public static Bearing Of(Locks locks, MassProperties mass) =>
            IsPart(locks & Locks.Move, Locks.Move) || IsPart(locks & Locks.Turn, Locks.Turn) ? new Bearing(locks, mass) : null;

        /// <summary>What is left of what acts on the body.</summary>
        public Wrench Left(Wrench given, Quaterniond orientation)
        {
            given.Force = _locks.Moving(given.Force);
            if (!ReadsOrientation)
                return given;

            Vector3d torque = Scaled(given.TorqueInWorld(orientation), _locks.Turning(_real.InversePrincipalMoments), orientation);
            return new Wrench { Force = given.Force, Torque = torque };
        }

        /// <summary>A push on the body as one that its locks have taken their part of.</summary>
        public IPush On(IPush push) => new Held(push, this);

        private Vector3d Scaled(Vector3d torque, Vector3d factors, Quaterniond orientation)
        {
            Quaterniond principal = (orientation * _real.PrincipalFrame).Normalized;
            return principal.Rotate(Vector3d.Scale(factors, principal.RotateInverse(torque)));
        }

        private static bool IsPart(Locks locked, Locks all) => locked != Locks.None && locked != all;

        private sealed class Held : IPush
        {
            private readonly IPush _push;
            private readonly Bearing _by;

            public Held(IPush push, Bearing by)
            {
                _push = push;
                _by = by;
            }

            public EffectTraits Traits => _push.Traits | (_by.ReadsOrientation ? EffectTraits.ReadsOrientation : EffectTraits.None);

            public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
            {
                Wrench given = Before(wrench, body);
                _push.At(now, body, _by._real, ref given);
                wrench = _by.Left(given, body.Orientation);
            }

            public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
            {
                Wrench given = Before(impulse, body);
                _push.Over(now, duration, body, _by._real, ref given);
                impulse = _by.Left(given, body.Orientation);
            }

            /// <summary>What others gave before, on the real body: a push that reads a velocity asks for that.</summary>
            private Wrench Before(Wrench left, in BodyState body)
            {
                if (_by.ReadsOrientation)
                    left.Torque = _by.Scaled(left.Torque, _by._real.PrincipalMoments, body.Orientation);

                return left;
            }
        }
    }
}
