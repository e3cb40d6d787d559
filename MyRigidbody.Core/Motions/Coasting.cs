namespace RigidBodyDynamics
{
    /// <summary>
    /// All effects on a body that have a closed form: v' = g − c v and L' = −c_ω L, and the lab's factors once a step. The sum
    /// of the scene's <see cref="ICoast"/> effects.
    /// </summary>
    public struct Coasting
    {
        /// <summary>
        /// When the state of a body that coasts is read, at most this many steps are taken one by one; the steps before them are one
        /// closed form.
        /// </summary>
        internal const int StepsBetweenClosedForms = 128;

        /// <summary>g and the acceleration by constant forces, m/s², world axes.</summary>
        public Vector3d Acceleration;

        /// <summary>c, 1/s.</summary>
        public double LinearDampingRate;

        /// <summary>c_ω, 1/s.</summary>
        public double AngularDampingRate;

        /// <summary>Factor on the velocity at the end of each step, whatever its length.</summary>
        public double LinearFactorPerStep;

        /// <summary>Factor on the angular velocity at the end of each step, whatever its length.</summary>
        public double AngularFactorPerStep;

        /// <summary>The rounding error of the time of a leap (<see cref="Leap"/>), s: over many revolutions it would matter.</summary>
        internal double Rest;

        /// <summary>Nothing acts.</summary>
        public static Coasting Free => new Coasting { LinearFactorPerStep = 1, AngularFactorPerStep = 1 };

        /// <summary>The factor of a velocity over a step by damping alone: exp(−c h), times the factor per step.</summary>
        public double LinearDecay(double duration) => Decay(LinearDampingRate, duration) * LinearFactorPerStep;

        /// <summary>The factor of an angular velocity over a step by damping alone.</summary>
        public double AngularDecay(double duration) => Decay(AngularDampingRate, duration) * AngularFactorPerStep;

        private static double Decay(double rate, double duration) => rate == 0 ? 1 : Elementary.Exp(-rate * duration);
    }
}
