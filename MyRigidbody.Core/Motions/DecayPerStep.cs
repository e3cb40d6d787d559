using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The lab's damping: velocity and angular velocity times a factor, once a step. The velocity after a second
    /// depends on the number of steps: with 0.98, 36 % at 50 steps a second, 30 % at 60, 5 % at 144.
    /// </summary>
    public readonly struct DecayPerStep : ICoast
    {
        private readonly double _linear;
        private readonly double _angular;

        /// <summary>One factor for the velocity and one for the angular velocity, each from 0 to 1.</summary>
        public DecayPerStep(double linear, double angular)
        {
            _linear = Factor(linear, "linear");
            _angular = Factor(angular, "angular");
        }

        public EffectTraits Traits =>
            EffectTraits.Moves | EffectTraits.Turns | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity | EffectTraits.IsDamping | EffectTraits.OncePerStep;

        public void AddTo(ref Coasting coasting, MassProperties mass)
        {
            coasting.LinearFactorPerStep *= _linear;
            coasting.AngularFactorPerStep *= _angular;
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() =>
            string.Format(CultureInfo.InvariantCulture, "v × {0:R}, ω × {1:R} a step", _linear, _angular);

        private static double Factor(double value, string name) =>
            value >= 0 && value <= 1 ? value : throw Guard.Refused(name, value, "must be a factor from 0 to 1");
    }
}
