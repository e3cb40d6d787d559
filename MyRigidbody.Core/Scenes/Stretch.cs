using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>An earlier state of a body, stored apart from what every step reads: so a cache holds more bodies.</summary>
    internal sealed class Kept<T> where T : struct
    {
        public T Value;
    }

    /// <summary>A stretch of steps during which the same effects act on a body.</summary>
    internal abstract class Stretch<TIntegrator> where TIntegrator : struct, IIntegrator
    {
        /// <summary>The state in which a body began to coast; null where none may.</summary>
        public Kept<TIntegrator> Anchor;

        protected Stretch(long end, bool isPushed)
        {
            End = end;
            IsPushed = isPushed;
        }

        /// <summary>The step after its last.</summary>
        public long End { get; }

        /// <summary>True if there is a push in it.</summary>
        public bool IsPushed { get; }

        /// <summary>The step length (s) that the integrator is prepared for by this stretch; 0 for none.</summary>
        public double PreparedFor { get; set; }

        /// <summary>Takes steps one by one.</summary>
        public abstract void Run(ref TIntegrator integrator, TimeSteps steps, long first, long end);

        /// <summary>True if a body at this step need not be stepped: no push acts, and its integrator has a closed form.</summary>
        public abstract bool LetsCoast(ref TIntegrator integrator, TimeSteps steps, long step);

        /// <summary>True if no push acts, and the integrator of a body in this state has a closed form.</summary>
        public abstract bool KnowsWay(TIntegrator integrator);

        /// <summary>Takes a body that has coasted since the anchor from one step to a later one.</summary>
        public abstract void Coast(ref TIntegrator integrator, TimeSteps steps, long anchored, long from, long to);

        /// <summary>The state a time (s) ago, of a body that has coasted since then.</summary>
        public abstract void Return(ref TIntegrator integrator, double time);

        /// <summary>Forgets what is prepared: the next state does not follow from the last one.</summary>
        public void Forget() => PreparedFor = 0;
    }

    /// <summary>A stretch whose sum of effects is a type, so that its step is compiled for this sum.</summary>
    internal sealed class Stretch<TIntegrator, TSum> : Stretch<TIntegrator>
        where TIntegrator : struct, IIntegrator
        where TSum : struct, IPush
    {
        // AggressiveOptimization, which .NET Standard 2.0 has no name for: a loop that is compiled again while it runs inlines
        // its step, but nothing that the step calls
        private const MethodImplOptions Optimised = (MethodImplOptions)512;
        private readonly Coasting _coasting;
        private TSum _sum;

        public Stretch(long end, in Coasting coasting, TSum sum) : base(end, (sum.Traits & (EffectTraits.Moves | EffectTraits.Turns)) != 0)
        {
            _coasting = coasting;
            _sum = sum;
        }

        [MethodImpl(Optimised)]
        public override void Run(ref TIntegrator integrator, TimeSteps steps, long first, long end)
        {
            for (long n = first; n < end; n++)
            {
                Prepare(ref integrator, steps.Length(n));
                integrator.Step(new Instant(n, steps.StartOf(n)), ref _sum);
            }
        }

        public override bool LetsCoast(ref TIntegrator integrator, TimeSteps steps, long step)
        {
            if (IsPushed || step >= End)
                return false;

            Prepare(ref integrator, steps.Length(step));
            return integrator.HasClosedForm;
        }

        public override bool KnowsWay(TIntegrator integrator)
        {
            if (IsPushed)
                return false;

            integrator.Prepare(1, _coasting);
            return integrator.HasClosedForm;
        }

        /// <summary>
        /// One step to the last multiple of some number of steps since the anchor, then step by step: so the bits do not depend on when
        /// states are read; reading at every step costs every step, reading rarely costs a few.
        /// </summary>
        public override void Coast(ref TIntegrator integrator, TimeSteps steps, long anchored, long from, long to)
        {
            long block = anchored + (to - anchored) / Coasting.StepsBetweenClosedForms * Coasting.StepsBetweenClosedForms;
            if (from < block)
            {
                integrator = Anchor.Value;
                Forget();
                Leap(ref integrator, steps.Between(anchored, block));
                from = block;
            }

            Run(ref integrator, steps, from, to);
        }

        public override void Return(ref TIntegrator integrator, double time) => Leap(ref integrator, -time);

        private void Leap(ref TIntegrator integrator, DoubleDouble time)
        {
            Coasting coasting = _coasting;
            coasting.Rest = time.Low;
            Leap leap = default(Leap);
            integrator.Prepare(time.High, coasting);
            // no push acts, so none needs the time
            integrator.Step(default(Instant), ref leap);
        }

        private void Prepare(ref TIntegrator integrator, double length)
        {
            if (length != PreparedFor)
                PrepareAnew(ref integrator, length);
        }

        // not inlined into the loop, which would otherwise keep its numbers in memory for this rare call
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void PrepareAnew(ref TIntegrator integrator, double length)
        {
            integrator.Prepare(length, _coasting);
            PreparedFor = length;
        }
    }
}
