using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>A spring of rest length zero, from a point of the body to a point of the world.</summary>
    public readonly struct Spring : IPush, ISwing
    {
        private readonly Vector3d _anchor;
        private readonly Vector3d _at;
        private readonly double _stiffness;

        /// <summary>The spring.</summary>
        /// <param name="anchor">Its end on the body, body frame, m.</param>
        /// <param name="at">Its end in the world, m.</param>
        /// <param name="stiffness">N/m.</param>
        public Spring(Vector3d anchor, Vector3d at, double stiffness)
        {
            _anchor = Guard.Finite(anchor, nameof(anchor));
            _at = Guard.Finite(at, nameof(at));
            _stiffness = Guard.NotNegative(stiffness, nameof(stiffness));
        }

        public EffectTraits Traits =>
            EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation | EffectTraits.HasPotential;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            Vector3d force = _stiffness * (_at - (body.Position + body.Orientation.Rotate(_anchor)));
            Vector3d arm = body.Orientation.Rotate(_anchor - mass.CenterOfMass);
            impulse.Force += duration * force;
            impulse.Torque += duration * Vector3d.Cross(arm, force);
        }

        /// <remarks>
        /// ω² = k (1/m + a²/I), a the arm and I the least moment. Exact where the spring acts on the centre of mass; with an arm,
        /// for oscillations that are small against it.
        /// </remarks>
        public double LongestStableStep(MassProperties mass)
        {
            Vector3d i = Guard.NotNull(mass, nameof(mass)).PrincipalMoments;
            double least = Math.Min(i.X, Math.Min(i.Y, i.Z));
            double arm = (_anchor - mass.CenterOfMass).LengthSquared;
            return 2 / Math.Sqrt(_stiffness * (mass.InverseMass + (arm > 0 ? arm / least : 0)));
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => string.Format(
            CultureInfo.InvariantCulture, "spring {0:R} N/m from {1} to {2}", _stiffness, _anchor, _at);
    }
}
