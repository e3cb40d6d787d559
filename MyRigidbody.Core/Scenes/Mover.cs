using System;

namespace RigidBodyDynamics
{
    /// <summary>Moves bodies by one plan: one body, or many that share the plan.</summary>
    internal abstract class Mover
    {
        /// <summary>The load on the body for one step; of many bodies, on the one that takes the step.</summary>
        public Load Load = Load.None;

        protected Mover(BodyPlan plan) => Plan = plan;

        /// <summary>The plan of the motion.</summary>
        public BodyPlan Plan { get; }

        /// <summary>True for a mover of many bodies.</summary>
        public virtual bool HasMany => false;

        /// <summary>The present state of a body.</summary>
        public abstract BodyState StateOf(Body body);

        /// <summary>Writes the states of many bodies, each to the index of its handle, and returns their number.</summary>
        public virtual int Read(BodyState[] states) => 0;

        public abstract bool IsAsleep(Body body);

        /// <summary>True while nothing is computed for a body until its state is read.</summary>
        public abstract bool IsDormant(Body body);

        /// <summary>Gives a body an impulse now; the pose does not change.</summary>
        public abstract void Push(Body body, in Wrench impulse);

        /// <summary>The same for a body as its integrator's struct; one whose velocity would not stay finite is not changed.</summary>
        public void Push<TIntegrator>(ref TIntegrator body, in Wrench impulse) where TIntegrator : struct, IIntegrator
        {
            TIntegrator pushed = body;
            pushed.Push(Plan.Bearing == null ? impulse : Plan.Bearing.Left(impulse, body.State.Orientation));
            if (!pushed.IsFinite)
                throw Guard.Refused("impulse", impulse.Force.IsFinite && impulse.Force.LengthSquared > 0 ? impulse.Force : impulse.Torque, "must leave a finite velocity");

            body = pushed;
        }

        /// <summary>Gives a body, as its integrator's struct, the impulses at the beginning of a step.</summary>
        public void Give<TIntegrator>(ref TIntegrator body, StretchPlan stretch) where TIntegrator : struct, IIntegrator
        {
            foreach (ImpulseEffect effect in stretch.Impulses)
            {
                try
                {
                    Wrench impulse = effect.Impulse.On(body.State.Orientation, Plan.Asked.Mass);
                    Push(ref body, stretch.MassCourse == null ? impulse : impulse.Times(1 / stretch.MassCourse.Ratio));
                }
                catch (ArgumentException refused)
                {
                    throw new BrokenEffectException(Plan.Asked, effect, new Instant(stretch.First, stretch.Starts), refused);
                }
            }
        }

        /// <summary>Sets the state of a body now.</summary>
        public abstract void Set(Body body, in BodyState state);

        /// <summary>Adds to the load on a body in the next step.</summary>
        public abstract void Add(Body body, in Load load);

        /// <summary>Removes a body.</summary>
        /// <returns>True if it was the last of many.</returns>
        public virtual bool Remove(Body body) => false;

        /// <summary>The mover of a body alone; a body of many leaves the others, to the same bits.</summary>
        public abstract LoneMover Alone(Body body);

        /// <summary>The last step, up to a given one, to which bodies can advance and still go back.</summary>
        public virtual long Limit(long end) => end;

        /// <summary>Advances to the end of a step, or as far as the effects let it; returns that step, and the exception that stopped it.</summary>
        public abstract long Advance(long end, ref Exception failure);

        /// <summary>Goes back to where the last <see cref="Advance"/> began.</summary>
        public abstract void GoBack();

        /// <summary>Called when all bodies of the simulation have reached the end of an <see cref="Advance"/>: none goes back from here.</summary>
        public virtual void Stay() { }

        /// <summary>Called at the end of a call: earlier times are not needed again. Bodies may coast from here, or are stepped on.</summary>
        public abstract void Arrive(bool mayCoast);

        public abstract object Save();

        public abstract void Restore(object saved);
    }

    /// <summary>The mover of one body.</summary>
    internal abstract class LoneMover : Mover
    {
        /// <summary>The last step, stored from the first time that it is interpolated; null before.</summary>
        public LastStep Last;

        protected LoneMover(BodyPlan plan) : base(plan) { }

        /// <summary>The body that it moves.</summary>
        public Body Owner { get; set; }

        /// <summary>The exception that names the body.</summary>
        protected StateOverflowException Lost(long step) => new StateOverflowException(Plan, step, isLoaded: Load.Step == step) { Handle = Owner };

        /// <summary>The step up to which the body, while it is dormant, need not be stepped.</summary>
        public abstract long WakesAt { get; }

        /// <summary>A state during the last step.</summary>
        public abstract BodyState Between(double alpha);

        /// <summary>Continues the motion of another mover at the present step, with all digits, where both store the same numbers.</summary>
        public abstract void TakeOver(Mover last);

        public override LoneMover Alone(Body body) => this;
    }

    /// <summary>Makes the mover of a body from its integrator as a type.</summary>
    internal sealed class MoverMaker : IRuleUse<LoneMover>
    {
        private readonly BodyPlan _plan;
        private readonly Clock _clock;

        public MoverMaker(BodyPlan plan, Clock clock)
        {
            _plan = plan;
            _clock = clock;
        }

        public LoneMover With<TIntegrator>() where TIntegrator : struct, IIntegrator => new Mover<TIntegrator>(_plan, _clock);
    }
}
