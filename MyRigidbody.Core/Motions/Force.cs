namespace RigidBodyDynamics
{
    /// <summary>
    /// A force constant + sine · sin(rate t) + cosine · cos(rate t), in world or in body axes, at the centre of mass or at a point of the
    /// body. A constant force in world axes at the centre of mass has a closed form, as gravity has; for <c>UnityRigidbody</c>, whose
    /// sleep depends on forces, it is a push.
    /// </summary>
    public readonly struct Force : IPush, ICoast
    {
        private readonly Harmonic _force;
        private readonly Vector3d _at;
        private readonly bool _inBody, _hasPoint;

        /// <summary>A constant force, N.</summary>
        /// <param name="force">N.</param>
        /// <param name="at">The point of the body where it acts, body frame, m; the centre of mass if absent.</param>
        /// <param name="inBody">True: along body axes, rotating with the body, as a thruster's. False: along world axes.</param>
        public Force(Vector3d force, Vector3d? at = null, bool inBody = false)
            : this(new Harmonic(force, Vector3d.Zero, Vector3d.Zero, 0, nameof(force)), at, inBody) { }

        /// <summary>A force that varies harmonically, N, with rate in rad/s.</summary>
        /// <param name="constant">The constant part, N.</param>
        /// <param name="sine">Factor of sin(rate t), N.</param>
        /// <param name="cosine">Factor of cos(rate t), N.</param>
        /// <param name="rate">rad/s.</param>
        /// <param name="at">The point of the body where it acts, body frame, m; the centre of mass if absent.</param>
        /// <param name="inBody">True: along body axes, rotating with the body. False: along world axes.</param>
        public Force(Vector3d constant, Vector3d sine, Vector3d cosine, double rate, Vector3d? at = null, bool inBody = false)
            : this(new Harmonic(constant, sine, cosine, rate), at, inBody) { }

        private Force(in Harmonic force, Vector3d? at, bool inBody)
        {
            _force = force;
            _hasPoint = at != null;
            _at = Guard.Finite(at ?? Vector3d.Zero, nameof(at));
            _inBody = inBody;
        }

        public EffectTraits Traits =>
            EffectTraits.Moves
            | (_hasPoint ? EffectTraits.Turns : EffectTraits.None)
            | (_hasPoint || _inBody ? EffectTraits.ReadsOrientation : EffectTraits.None)
            | (_force.Swings ? EffectTraits.ReadsTime : _inBody ? EffectTraits.None : EffectTraits.HasPotential);

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Add(now, 0, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            Add(now, now.IsHeld ? 0 : duration, duration, body, mass, ref impulse);

        public void AddTo(ref Coasting coasting, MassProperties mass) => coasting.Acceleration += _force.Mean(0, 0) / mass.Mass;

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() =>
            "force " + _force + " N" + (_hasPoint ? " at " + _at + " m of the body" : string.Empty) + (_inBody ? ", body axes" : string.Empty);

        private void Add(in Instant now, double duration, double factor, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            if (!_inBody && !_hasPoint)
            {
                _force.Add(now.Time, duration, factor, ref wrench.Force);
                return;
            }

            Vector3d force = _force.Mean(now.Time, duration);
            wrench.Force += factor * (_inBody ? body.Orientation.Rotate(force) : force);
            if (!_hasPoint)
                return;

            Vector3d arm = _at - mass.CenterOfMass;
            if (_inBody)
                wrench.BodyTorque += factor * Vector3d.Cross(arm, force);
            else
                wrench.Torque += factor * Vector3d.Cross(body.Orientation.Rotate(arm), force);
        }
    }
}
