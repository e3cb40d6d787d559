namespace RigidBodyDynamics
{
    /// <summary>A stretch of steps during which the same effects act on a body.</summary>
    internal abstract class Stretch<TIntegrator> where TIntegrator : struct, IIntegrator
    {
        protected Stretch(long end)
        {
            End = end;
        }

        /// <summary>The step after its last.</summary>
        public long End { get; }

        public abstract void Run(ref TIntegrator integrator, TimeSteps steps, long first, long end);
    }

    /// <summary>A stretch whose sum of effects is a type, so that its step is compiled for just that sum.</summary>
    internal sealed class Stretch<TIntegrator, TSum> : Stretch<TIntegrator>
        where TIntegrator : struct, IIntegrator
        where TSum : struct, IPush
    {
        private readonly Coasting _coasting;
        private TSum _sum;
        private double _preparedFor;

        public Stretch(long end, in Coasting coasting, TSum sum) : base(end)
        {
            _coasting = coasting;
            _sum = sum;
        }

        public override void Run(ref TIntegrator integrator, TimeSteps steps, long first, long end)
        {
            for (long n = first; n < end; n++)
            {
                double length = steps.Length(n);
                if (length != _preparedFor)
                {
                    integrator.Prepare(length, _coasting);
                    _preparedFor = length;
                }

                integrator.Step(new Instant(n, steps.StartOf(n)), ref _sum);
            }
        }
    }
}
