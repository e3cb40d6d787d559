using System;

namespace RigidBodyDynamics
{
    /// <summary>A push whose result is tested: it must be finite, and the push must add something.</summary>
    internal sealed class Watched : IPush
    {
        private readonly PushEffect _effect;
        private readonly BodyDescription _body;

        public Watched(PushEffect effect, BodyDescription body)
        {
            _effect = effect;
            _body = body;
        }

        public EffectTraits Traits => _effect.Push.Traits;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            bool was = wrench.IsFinite;
            try
            {
                _effect.Push.At(now, body, mass, ref wrench);
            }
            catch (Exception thrown)
            {
                throw Broken(now, thrown);
            }

            Look(now, body, was, wrench);
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            bool was = impulse.IsFinite;
            try
            {
                _effect.Push.Over(now, duration, body, mass, ref impulse);
            }
            catch (Exception thrown)
            {
                throw Broken(now, thrown);
            }

            Look(now, body, was, impulse);
        }

        /// <summary>Where the state had already diverged, the integrator is the cause and not the effect.</summary>
        private void Look(in Instant now, in BodyState body, bool was, in Wrench given)
        {
            if (was && body.IsFinite && !given.IsFinite)
                throw Broken(now, null);
        }

        private BrokenEffectException Broken(in Instant now, Exception thrown) =>
            new BrokenEffectException(_body, _effect, now, thrown);
    }
}
