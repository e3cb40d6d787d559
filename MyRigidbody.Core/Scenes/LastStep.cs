namespace RigidBodyDynamics
{
    /// <summary>The last step of a body, for interpolation.</summary>
    internal abstract class LastStep
    {
        protected BodyState From, To;
        protected Vector3d Center;
        protected double Length;

        /// <summary>The number of steps done after it.</summary>
        public long Step { get; private set; } = -1;

        /// <summary>Stores a step from one state to another, and its length.</summary>
        public void Went(long step, double length, in BodyState from, in BodyState to, Vector3d centerOfMass)
        {
            Jump(step, to);
            From = from;
            Length = length;
            Center = centerOfMass;
        }

        /// <summary>Stores a state that the program has set: there is no path to it.</summary>
        public virtual void Jump(long step, in BodyState to)
        {
            Step = step;
            From = To = to;
            Length = 0;
        }

        /// <summary>The state after a part of the step.</summary>
        public virtual BodyState At(double part)
        {
            if (part == 1 || Length == 0)
                return To;

            return part == 0 ? From : BodyState.Between(From, To, Center, Length, part);
        }

        public LastStep Copy() => (LastStep)MemberwiseClone();
    }

    /// <summary>The same for a body whose integrator may have a closed form.</summary>
    internal sealed class LastStep<TIntegrator> : LastStep where TIntegrator : struct, IIntegrator
    {
        private TIntegrator _motion;
        private Stretch<TIntegrator> _coasted;

        /// <summary>Stores a step of a body that coasted: it is evaluated backwards on the closed form.</summary>
        public void Coasted(long step, double length, in TIntegrator motion, Stretch<TIntegrator> stretch)
        {
            Went(step, length, motion.State, motion.State, Vector3d.Zero);
            _motion = motion;
            _coasted = stretch;
        }

        public override void Jump(long step, in BodyState to)
        {
            base.Jump(step, to);
            _coasted = null;
        }

        public override BodyState At(double part)
        {
            if (_coasted == null || part == 1)
                return base.At(part);

            TIntegrator motion = _motion;
            _coasted.Return(ref motion, (1 - part) * Length);
            return motion.State;
        }
    }
}
