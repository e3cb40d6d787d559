#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>Storage of bodies that differ only in their states, each in a place.</summary>
    internal abstract class Crowd
    {
        /// <summary>The number of neighbours that are stepped together; every range of places begins and ends at a multiple of it.</summary>
        public abstract int Width { get; }

        /// <summary>Makes room for a number of bodies, a power of two, and for their stored states.</summary>
        public abstract void Reserve(int capacity);

        /// <summary>Puts a body in a place.</summary>
        public abstract void Start(int place, BodyDescription body);

        /// <summary>Moves a body, with its stored state, to another place.</summary>
        public abstract void Move(int from, int to);

        public abstract BodyState StateOf(int place);

        /// <summary>Writes the states of bodies, each to the index of its handle. False if a body has none.</summary>
        public virtual bool Read(int from, int to, Places places, BodyState[] states)
        {
            for (int i = from; i < to; i++)
                states[places[i].Index] = StateOf(i);

            return FirstLost(from, to) < 0;
        }

        /// <summary>The first place in a range whose body has no finite state; −1 if there is none.</summary>
        public abstract int FirstLost(int from, int to);

        /// <summary>True while the integrator has put the body to sleep; no integrator in lanes does.</summary>
        public virtual bool IsAsleep(int place) => false;

        /// <summary>Another stretch begins: nothing is prepared for it.</summary>
        public abstract void Forget(int from, int to);

        /// <summary>True if, in a stretch without pushes, the integrator has a closed form for the body.</summary>
        public abstract bool HasClosedForm(int place, in Coasting coasting);

        /// <summary>Stores the present states.</summary>
        public abstract void Keep(int from, int to);

        /// <summary>Restores the stored states.</summary>
        public abstract void Return(int from, int to);

        /// <summary>Sets the present states to the stored ones a time (s) later, each in one step.</summary>
        public abstract void Leap(int from, int to, DoubleDouble time, in Coasting coasting);

        /// <summary>The exception that keeps a body from making a step, found by watching every push; null if nothing does.</summary>
        /// <param name="plan">The plan of the bodies.</param>
        /// <param name="stretch">The stretch of the step.</param>
        /// <param name="place">The place of the body, which is before the step.</param>
        /// <param name="handle">The body.</param>
        /// <param name="step">The step.</param>
        /// <param name="aside">Gives the impulses of a step that the body makes apart from the others; null where it does not.</param>
        /// <param name="isLoaded">True if the load of that mover acts, too.</param>
        public abstract Exception Blame(BodyPlan plan, int stretch, int place, Body handle, long step, Mover aside = null, bool isLoaded = false);

        /// <summary>Gives a body an impulse. False if its state was not finite before.</summary>
        public abstract bool Push(Mover mover, int place, in Wrench impulse);

        /// <summary>
        /// Stores a body, after a step that it makes alone with the impulses at its beginning, apart; its place keeps the state before.
        /// </summary>
        /// <param name="mover">The mover of the body, which has its load.</param>
        /// <param name="stretch">The stretch of the step.</param>
        /// <param name="place">Where the body is.</param>
        /// <param name="step">The step.</param>
        /// <param name="isLoaded">True if the load acts.</param>
        /// <returns>False where the step leads to no finite state.</returns>
        public abstract bool StepAside(Mover mover, int stretch, int place, long step, bool isLoaded);

        /// <summary>Takes a body that was stored apart, by its number among them, into a place.</summary>
        public abstract void TakeBack(int aside, int place);

        /// <summary>Forgets all bodies that were stored apart.</summary>
        public abstract void ForgetAside();

        /// <summary>A mover for one body alone.</summary>
        /// <param name="plan">The plan of the body.</param>
        /// <param name="clock">The clock of the simulation.</param>
        /// <param name="place">Where the body is.</param>
        /// <param name="since">The step at which its state was stored.</param>
        /// <param name="keptIn">The stretch of that step.</param>
        /// <param name="stretch">The stretch in which it is.</param>
        /// <param name="coasts">Whether it has coasted since then.</param>
        public abstract LoneMover Alone(BodyPlan plan, Clock clock, int place, long since, int keptIn, int stretch, bool coasts);

        /// <summary>A stepper for one thread.</summary>
        public abstract Stepper NewStepper(BodyPlan plan);

        /// <summary>A copy of all bodies.</summary>
        public abstract object Save();

        /// <summary>Restores all bodies from a copy, with the room there was.</summary>
        public abstract void Restore(object saved);
    }

    /// <summary>Steps parts of a crowd, one part at a time.</summary>
    internal abstract class Stepper
    {
        /// <summary>Takes the bodies in some places from one step to another of the same stretch.</summary>
        public abstract void Run(int stretch, int from, int to, long first, long end);
    }

    /// <summary>
    /// An integrator of many bodies, seen as an integrator whose body is many: so a stretch binds its pushes to it as to any other.
    /// </summary>
    internal interface ICrowdRule : IIntegrator
    {
        /// <summary>Selects the bodies of the next steps.</summary>
        void Select(int from, int to);
    }

    /// <summary>Stretches of a plan, bound to an integrator of many bodies.</summary>
    internal sealed class Stepper<TRule> : Stepper where TRule : struct, ICrowdRule
    {
        private readonly TimeSteps _steps;
        private readonly Stretch<TRule>[] _stretches;
        private readonly TRule[] _rules;

        public Stepper(BodyPlan plan, TRule rule)
        {
            _steps = plan.Steps;
            _stretches = StretchBuilder<TRule>.Bind(plan, isWatched: false);
            // what an integrator prepares is valid for one stretch
            _rules = new TRule[_stretches.Length];
            for (int i = 0; i < _rules.Length; i++)
            {
                _rules[i] = rule;
                _rules[i].Start(new Beginning(plan.Body));
            }
        }

        public override void Run(int stretch, int from, int to, long first, long end)
        {
            _rules[stretch].Select(from, to);
            _stretches[stretch].Run(ref _rules[stretch], _steps, first, end);
        }
    }
}
#endif
