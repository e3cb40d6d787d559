using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>What a body was once, apart from what every step reads: so more bodies have room in a cache.</summary>
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

        /// <summary>True if something pushes in it.</summary>
        public bool IsPushed { get; }

        /// <summary>The length of steps (s) that the rule is prepared for by this stretch; 0 for none.</summary>
        public double PreparedFor { get; set; }

        /// <summary>Steps one by one.</summary>
        public abstract void Run(ref TIntegrator integrator, TimeSteps steps, long first, long end);

        /// <summary>True if a body at this step need not be stepped: nothing pushes it, and its rule knows where it will be.</summary>
        public abstract bool LetsCoast(ref TIntegrator integrator, TimeSteps steps, long step);

        /// <summary>True if nothing pushes, and the rule of a body in this state knows its way at every time.</summary>
        public abstract bool KnowsWay(TIntegrator integrator);

        /// <summary>From a state at one step to that at a later one, of a body that coasts since it was at the anchor.</summary>
        public abstract void Coast(ref TIntegrator integrator, TimeSteps steps, long anchored, long from, long to);

        /// <summary>The state a time (s) ago, of a body that has coasted since.</summary>
        public abstract void Return(ref TIntegrator integrator, double time);

        /// <summary>Another state follows than the one that was here last.</summary>
        public void Forget() => PreparedFor = 0;
    }

    /// <summary>A stretch whose sum of effects is a type, so that its step is compiled for just that sum.</summary>
    internal sealed class Stretch<TIntegrator, TSum> : Stretch<TIntegrator>
        where TIntegrator : struct, IIntegrator
        where TSum : struct, IPush
    {
        // AggressiveOptimization, which .NET Standard 2.0 has no name for: a loop that is compiled again while it runs gets its
        // step inlined, and nothing of what the step calls
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
        /// In one step to the last multiple of some steps since the anchor, then step by step: so the bits do not depend
        /// on who looked when, who looks at every step pays for every step, and who looks rarely for a few.
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
            // no push is asked, so none learns when
            integrator.Step(default(Instant), ref leap);
        }

        private void Prepare(ref TIntegrator integrator, double length)
        {
            if (length != PreparedFor)
                PrepareAnew(ref integrator, length);
        }

        // not within the loop, which would keep its numbers in memory for what is done once
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void PrepareAnew(ref TIntegrator integrator, double length)
        {
            integrator.Prepare(length, _coasting);
            PreparedFor = length;
        }
    }
}
