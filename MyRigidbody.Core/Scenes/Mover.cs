using System;

namespace RigidBodyDynamics
{
    /// <summary>What moves bodies, from one plan to the next: one body, or many that share a plan.</summary>
    internal abstract class Mover
    {
        /// <summary>What the program pushes with in one step: the body, or that of many which makes the step.</summary>
        public Load Load = Load.None;

        protected Mover(BodyPlan plan) => Plan = plan;

        /// <summary>What the motion consists of.</summary>
        public BodyPlan Plan { get; }

        /// <summary>True for a mover of many bodies.</summary>
        public virtual bool HasMany => false;

        /// <summary>The state of a body now.</summary>
        public abstract BodyState StateOf(Body body);

        /// <summary>Gives the states of many, each to the index of its handle, and says how many they are.</summary>
        public virtual int Read(BodyState[] states) => 0;

        public abstract bool IsAsleep(Body body);

        /// <summary>True while nothing is computed for a body until its state is read.</summary>
        public abstract bool IsDormant(Body body);

        /// <summary>An impulse now; the pose stays.</summary>
        public abstract void Push(Body body, in Wrench impulse);

        /// <summary>The same of a body as its rule keeps it; one that would lose its velocity in it stays as it was.</summary>
        public void Push<TIntegrator>(ref TIntegrator body, in Wrench impulse) where TIntegrator : struct, IIntegrator
        {
            TIntegrator pushed = body;
            pushed.Push(Plan.Bearing == null ? impulse : Plan.Bearing.Left(impulse, body.State.Orientation));
            if (!pushed.IsFinite)
                throw Guard.Refused("impulse", impulse.Force.IsFinite && impulse.Force.LengthSquared > 0 ? impulse.Force : impulse.Torque, "must leave a finite velocity");

            body = pushed;
        }

        /// <summary>Gives a body, as its rule keeps it, the impulses with which a step begins.</summary>
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

        /// <summary>Another state now.</summary>
        public abstract void Set(Body body, in BodyState state);

        /// <summary>Adds to what pushes a body in the next step.</summary>
        public abstract void Add(Body body, in Load load);

        /// <summary>A body goes.</summary>
        /// <returns>True if it was the last of many.</returns>
        public virtual bool Remove(Body body) => false;

        /// <summary>The mover of a body by itself; one of many leaves them, to the same bits.</summary>
        public abstract LoneMover Alone(Body body);

        /// <summary>How far, up to a step, bodies can go so that there is still a way back.</summary>
        public virtual long Limit(long end) => end;

        /// <summary>Goes on to the end of a step, or as far as the effects let it; what stopped it comes with the answer.</summary>
        public abstract long Advance(long end, ref Exception failure);

        /// <summary>Back to where the last <see cref="Advance"/> began.</summary>
        public abstract void GoBack();

        /// <summary>All bodies of the simulation have come to the end of an <see cref="Advance"/>: nobody goes back from here.</summary>
        public virtual void Stay() { }

        /// <summary>Comes to now: times before are not asked for again. Bodies may coast from here, or are stepped on.</summary>
        public abstract void Arrive(bool mayCoast);

        public abstract object Save();

        public abstract void Restore(object saved);
    }

    /// <summary>What moves one body.</summary>
    internal abstract class LoneMover : Mover
    {
        /// <summary>The last step, kept from the first time that a state in it is asked for; null before.</summary>
        public LastStep Last;

        protected LoneMover(BodyPlan plan) : base(plan) { }

        /// <summary>The body that it moves.</summary>
        public Body Owner { get; set; }

        /// <summary>The error that names the body.</summary>
        protected StateOverflowException Lost(long step) => new StateOverflowException(Plan, step, isLoaded: Load.Step == step) { Handle = Owner };

        /// <summary>The step by which the body has to be stepped again, while it is dormant.</summary>
        public abstract long WakesAt { get; }

        /// <summary>The states between the beginning and the end of the last step.</summary>
        public abstract BodyState Between(double alpha);

        /// <summary>Goes on with the motion of another that has come to now, to its last digit, where both move it by the same numbers.</summary>
        public abstract void TakeOver(Mover last);

        public override LoneMover Alone(Body body) => this;
    }
}
