namespace RigidBodyDynamics
{
    /// <summary>The last step of a body, for those who draw between two steps.</summary>
    internal abstract class LastStep
    {
        protected BodyState From, To;
        protected Vector3d Center;
        protected double Length;

        /// <summary>The step that had just been done.</summary>
        public long Step { get; private set; } = -1;

        /// <summary>The body went from one state to another, in some seconds.</summary>
        public void Went(long step, double length, in BodyState from, in BodyState to, Vector3d centerOfMass)
        {
            Jump(step, to);
            From = from;
            Length = length;
            Center = centerOfMass;
        }

        /// <summary>The body was put into a state: there is no way to it.</summary>
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

    /// <summary>The same of a body whose rule may know the whole way.</summary>
    internal sealed class LastStep<TIntegrator> : LastStep where TIntegrator : struct, IIntegrator
    {
        private TIntegrator _motion;
        private Stretch<TIntegrator> _coasted;

        /// <summary>The body coasted: it goes back on its own way.</summary>
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
