using System;

namespace RigidBodyDynamics
{
    /// <summary>What moves a body, from one plan to the next.</summary>
    internal abstract class Mover
    {
        /// <summary>What the program pushes with in one step.</summary>
        public Load Load = Load.None;

        /// <summary>The last step, kept from the first time that a state in it is asked for; null before.</summary>
        public LastStep Last;

        protected Mover(BodyPlan plan) => Plan = plan;

        /// <summary>What the motion consists of.</summary>
        public BodyPlan Plan { get; }

        /// <summary>The state now.</summary>
        public abstract BodyState State { get; }

        public abstract bool IsAsleep { get; }

        /// <summary>True while nothing is computed for the body until its state is read.</summary>
        public abstract bool IsDormant { get; }

        /// <summary>The step by which it has to be stepped again, while it is dormant.</summary>
        public abstract long WakesAt { get; }

        /// <summary>Goes on to the end of a step, or as far as the effects let it; what stopped it comes with the answer.</summary>
        public abstract long Advance(long end, ref Exception failure);

        /// <summary>Back to where the last <see cref="Advance"/> began.</summary>
        public abstract void GoBack();

        /// <summary>The states between the beginning and the end of the last step.</summary>
        public abstract BodyState Between(double alpha);

        /// <summary>An impulse now; the pose stays.</summary>
        public abstract void Push(in Wrench impulse);

        /// <summary>Another state now.</summary>
        public abstract void Set(in BodyState state);

        /// <summary>Adds to the <see cref="Load"/> of the next step.</summary>
        public abstract void Add(in Load load);

        /// <summary>Goes on with the motion of another that has come to now, to its last digit, where both move it by the same numbers.</summary>
        public abstract void TakeOver(Mover last);

        /// <summary>Comes to now: times before are not asked for again. A body may coast from here, or is stepped on.</summary>
        public abstract void Arrive(bool mayCoast);

        public abstract object Save();

        public abstract void Restore(object saved);
    }
}
