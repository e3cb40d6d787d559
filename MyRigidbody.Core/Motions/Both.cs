using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>Two pushes together. Sums of any number are nested from it, so that the compiler can inline them.</summary>
    internal struct Both<TFirst, TSecond> : IPush
        where TFirst : struct, IPush
        where TSecond : struct, IPush
    {
        private TFirst _first;
        private TSecond _second;

        /// <summary>The sum of two pushes.</summary>
        public Both(TFirst first, TSecond second)
        {
            _first = first;
            _second = second;
        }

        public EffectTraits Traits => _first.Traits.And(_second.Traits);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            _first.At(now, body, mass, ref wrench);
            _second.At(now, body, mass, ref wrench);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.IsReversed)
                _second.Over(now, duration, body, mass, ref impulse);

            _first.Over(now, duration, body, mass, ref impulse);
            if (!now.IsReversed)
                _second.Over(now, duration, body, mass, ref impulse);
        }
    }
}
