using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Gravity's torque about a pivot: −moment (axis × up). The body's inertia must be the one about the pivot, which
    /// <see cref="MassProperties.HeldAtOrigin"/> computes; with the inertia about its centre of mass a thin rod would swing in half the period.
    /// </summary>
    public readonly struct HeavyTop : IPush
    {
        private readonly Vector3d _axis;
        private readonly Vector3d _up;
        private readonly double _moment;

        /// <summary>The torque.</summary>
        /// <param name="axis">From the pivot to the centre of mass, body axes; only its direction matters.</param>
        /// <param name="moment">m g l, N m.</param>
        /// <param name="up">World axes; only its direction matters.</param>
        public HeavyTop(Vector3d axis, double moment, Vector3d up)
        {
            Guard.Finite(axis, nameof(axis));
            Guard.Finite(up, nameof(up));
            _axis = axis / Guard.Positive(axis.Length, "length of axis");
            _up = up / Guard.Positive(up.Length, "length of up");
            _moment = Guard.Finite(moment, nameof(moment));
        }

        public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsOrientation | EffectTraits.HasPotential | EffectTraits.IsGravity;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.BodyTorque -= duration * _moment * Vector3d.Cross(_axis, body.Orientation.RotateInverse(_up));

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture, "heavy top, m g l = {0:R} N m along {1}, up {2}", _moment, _axis, _up);
    }
}
