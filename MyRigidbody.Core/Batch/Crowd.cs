#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>Bodies side by side that differ in their states alone, each in a place; and how they are stored.</summary>
    internal abstract class Crowd
    {
        /// <summary>So many neighbours are stepped together; what is stepped begins and ends at a multiple of this.</summary>
        public abstract int Width { get; }

        /// <summary>Makes room for a number of bodies, a power of two, and for what is kept of them.</summary>
        public abstract void Reserve(int capacity);

        /// <summary>Puts a body in a place.</summary>
        public abstract void Start(int place, BodyDescription body);

        /// <summary>Takes a body, with what is kept of it, to another place.</summary>
        public abstract void Move(int from, int to);

        public abstract BodyState StateOf(int place);

        /// <summary>The states of bodies, each to the index of its handle.</summary>
        public virtual void Read(int from, int to, Places places, BodyState[] states)
        {
            for (int i = from; i < to; i++)
                states[places[i].Index] = StateOf(i);
        }

        /// <summary>The first place from one to another whose body has run away; −1 if none has.</summary>
        public abstract int FirstLost(int from, int to);

        /// <summary>True while its rule has put a body to sleep; no rule that goes in lanes does.</summary>
        public virtual bool IsAsleep(int place) => false;

        /// <summary>Another stretch begins: nothing is prepared for it.</summary>
        public abstract void Forget(int from, int to);

        /// <summary>True if, in a stretch that does not push, the body's rule knows where it will be at any time.</summary>
        public abstract bool HasClosedForm(int place, in Coasting coasting);

        /// <summary>Keeps the states as they are now.</summary>
        public abstract void Keep(int from, int to);

        /// <summary>Makes the states again those that were kept.</summary>
        public abstract void Return(int from, int to);

        /// <summary>Makes of the states that were kept those a time (s) later, each in one step.</summary>
        public abstract void Leap(int from, int to, DoubleDouble time, in Coasting coasting);

        /// <summary>What keeps a body from making a step, tried with every push watched; null if nothing does.</summary>
        /// <param name="plan">What the bodies do.</param>
        /// <param name="stretch">The stretch of the step.</param>
        /// <param name="place">Where the body is, which stands before the step.</param>
        /// <param name="handle">The body.</param>
        /// <param name="step">The step.</param>
        /// <param name="aside">Gives the impulses of a step that the body makes aside; null where it does not.</param>
        /// <param name="isLoaded">True if the load of that acts besides.</param>
        public abstract Exception Blame(BodyPlan plan, int stretch, int place, Body handle, long step, Mover aside = null, bool isLoaded = false);

        /// <summary>An impulse on a body. False where it has run away before.</summary>
        public abstract bool Push(Mover mover, int place, in Wrench impulse);

        /// <summary>
        /// Puts aside a body after a step that it makes by itself, with the impulses that the step begins with; the one in its place stays.
        /// </summary>
        /// <param name="mover">What moves it, and has its load.</param>
        /// <param name="stretch">The stretch of the step.</param>
        /// <param name="place">Where the body is.</param>
        /// <param name="step">The step.</param>
        /// <param name="isLoaded">True if the load acts.</param>
        /// <returns>False where it comes to no state.</returns>
        public abstract bool StepAside(Mover mover, int stretch, int place, long step, bool isLoaded);

        /// <summary>Takes a body that was put aside, by its number among them, into a place.</summary>
        public abstract void TakeBack(int aside, int place);

        /// <summary>Nobody is aside any more.</summary>
        public abstract void ForgetAside();

        /// <summary>A mover for a body by itself.</summary>
        /// <param name="plan">What the body does.</param>
        /// <param name="clock">When it is now.</param>
        /// <param name="place">Where the body is.</param>
        /// <param name="since">The step at which it was kept.</param>
        /// <param name="keptIn">The stretch of that step.</param>
        /// <param name="stretch">The stretch in which it is.</param>
        /// <param name="coasts">Whether it coasts since then.</param>
        public abstract LoneMover Alone(BodyPlan plan, Clock clock, int place, long since, int keptIn, int stretch, bool coasts);

        /// <summary>What one thread needs to step parts of the crowd.</summary>
        public abstract Stepper NewStepper(BodyPlan plan);

        /// <summary>A copy of all.</summary>
        public abstract object Save();

        /// <summary>All again as it was copied, with the room there was.</summary>
        public abstract void Restore(object saved);
    }

    /// <summary>Steps parts of a crowd, one part at a time.</summary>
    internal abstract class Stepper
    {
        /// <summary>Takes the bodies in some places from one step to another of the same stretch.</summary>
        public abstract void Run(int stretch, int from, int to, long first, long end);
    }

    /// <summary>
    /// A rule for many bodies is a rule whose body is many: so a stretch binds its pushes to it as it does to any rule.
    /// </summary>
    internal interface ICrowdRule : IIntegrator
    {
        /// <summary>Which bodies the next steps are for.</summary>
        void Select(int from, int to);
    }

    /// <summary>Stretches of a plan, bound to a rule for many bodies.</summary>
    internal sealed class Stepper<TRule> : Stepper where TRule : struct, ICrowdRule
    {
        private readonly TimeSteps _steps;
        private readonly Stretch<TRule>[] _stretches;
        private readonly TRule[] _rules;

        public Stepper(BodyPlan plan, TRule rule)
        {
            _steps = plan.Steps;
            _stretches = StretchBuilder<TRule>.Bind(plan, isWatched: false);
            // what a rule prepares holds for one stretch
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
