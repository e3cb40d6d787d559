namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect of no duration: velocities change at once and the pose does not. It acts at the beginning of a step, so every integrator
    /// computes it exactly: <c>body.With(new Impulse(...), time)</c>.
    /// </summary>
    public readonly struct Impulse : IEffect
    {
        private readonly Vector3d _linear, _angular, _at;
        private readonly bool _inBody, _hasPoint;

        /// <summary>The impulse, in world or in body axes.</summary>
        /// <param name="linear">N s.</param>
        /// <param name="angular">N m s, in addition to that of the linear impulse at its point.</param>
        /// <param name="at">The point of the body where the linear impulse acts, body frame, m; the centre of mass if absent.</param>
        /// <param name="inBody">True: along the body axes at that time. False: along world axes.</param>
        public Impulse(Vector3d linear, Vector3d angular = default(Vector3d), Vector3d? at = null, bool inBody = false)
        {
            _linear = Guard.Finite(linear, nameof(linear));
            _angular = Guard.Finite(angular, nameof(angular));
            _hasPoint = at != null;
            _at = Guard.Finite(at ?? Vector3d.Zero, nameof(at));
            _inBody = inBody;
        }

        public EffectTraits Traits =>
            (_linear.IsZero ? EffectTraits.None : EffectTraits.Moves)
            | (_angular.IsZero && (_linear.IsZero || !_hasPoint) ? EffectTraits.None : EffectTraits.Turns);

        /// <summary>The impulse on a body about its centre of mass, N s and N m s.</summary>
        internal Wrench On(Quaterniond orientation, MassProperties mass)
        {
            Vector3d linear = _inBody ? orientation.Rotate(_linear) : _linear, arm = _hasPoint ? _at - mass.CenterOfMass : Vector3d.Zero;
            return _inBody
                ? new Wrench { Force = linear, BodyTorque = Vector3d.Cross(arm, _linear) + _angular }
                : new Wrench { Force = linear, Torque = Vector3d.Cross(orientation.Rotate(arm), linear) + _angular };
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() =>
            "impulse " + _linear + " N s" + (_hasPoint ? " at " + _at + " m of the body" : string.Empty)
            + (_angular.IsZero ? string.Empty : " and " + _angular + " N m s") + (_inBody ? ", body axes" : string.Empty);
    }
}
