namespace RigidBodyDynamics
{
    /// <summary>
    /// Removes from the wrench on a body what its <see cref="Locks"/> take up, and scales torques so that a body with three equal
    /// moments of 1 kg m² rotates under them in the same way: its ω is constant without a torque, as that of a locked body is. So no
    /// integrator needs to treat locks, and the exact ones are exact.
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

        /// <summary>The mass properties that the integrator uses.</summary>
        public MassProperties Mass { get; }

        /// <summary>True if torques depend on the body's axes.</summary>
        public bool ReadsOrientation => Mass != _real;

        /// <summary>Null where no axis is locked, or the whole translation or rotation is: an integrator treats those cases itself.</summary>
        public static Bearing Of(Locks locks, MassProperties mass) =>
            IsPart(locks & Locks.Move, Locks.Move) || IsPart(locks & Locks.Turn, Locks.Turn) ? new Bearing(locks, mass) : null;

        /// <summary>The wrench without what the locks take up.</summary>
        public Wrench Left(Wrench given, Quaterniond orientation)
        {
            given.Force = _locks.Moving(given.Force);
            if (!ReadsOrientation)
                return given;

            Vector3d torque = Scaled(given.TorqueInWorld(orientation), _locks.Turning(_real.InversePrincipalMoments), orientation);
            return new Wrench { Force = given.Force, Torque = torque };
        }

        /// <summary>A push on the body, without what its locks take up.</summary>
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

            /// <summary>The impulse of the pushes before, on the real body: a push that reads a velocity needs it.</summary>
            private Wrench Before(Wrench left, in BodyState body)
            {
                if (_by.ReadsOrientation)
                    left.Torque = _by.Scaled(left.Torque, _by._real.PrincipalMoments, body.Orientation);

                return left;
            }
        }
    }
}
