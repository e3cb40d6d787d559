#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Which body of a crowd was the first to run away, and after which step: the same one, whichever thread looks when.
    /// </summary>
    internal sealed class Losses
    {
        private const int Nobody = -1;

        private readonly BodyPlan _plan;
        private readonly Crowd _crowd;
        private readonly object _key = new object();
        private long _step;
        private int _place;

        public Losses(BodyPlan plan, Crowd crowd)
        {
            _plan = plan;
            _crowd = crowd;
            Forget();
        }

        /// <summary>True if a body was found that has run away.</summary>
        public bool Any => _place != Nobody;

        public void Forget() => _place = Nobody;

        /// <summary>Looks whether the bodies in some places still have states after a step.</summary>
        public void Look(int from, int to, long step)
        {
            int place = _crowd.FirstLost(from, to);
            if (place < 0)
                return;

            lock (_key)
            {
                if (Any && (_step < step || (_step == step && _place < place)))
                    return;

                _place = place;
                _step = step;
            }
        }

        /// <summary>The error that names the body, or the effect if one did not give a finite force since the last look.</summary>
        /// <param name="places">Knows the bodies' numbers.</param>
        public StateOverflowException Found(Places places)
        {
            for (long step = Math.Max(0, _step + 1 - Batch.StepsBetweenLooks); step <= _step; step++)
                Ask(step);

            return new StateOverflowException(_plan, _step, places.IdAt(_place));
        }

        /// <summary>The effects that read nothing but the time can be asked what they gave.</summary>
        private void Ask(long step)
        {
            Instant now = new Instant(step, _plan.Steps.StartOf(step));
            foreach (StretchPlan stretch in _plan.Stretches)
            {
                for (int i = 0; stretch.First <= step && step < stretch.End && i < stretch.Pushes.Count; i++)
                {
                    PushEffect effect = stretch.Pushes[i];
                    if ((effect.Push.Traits & Crowds.ReadsState) != 0)
                        continue;

                    Watched watched = new Watched(effect, _plan.Body);
                    Wrench force = default(Wrench), impulse = default(Wrench);
                    watched.At(now, BodyState.AtRest, _plan.Body.Mass, ref force);
                    watched.Over(now, _plan.Steps.Length(step), BodyState.AtRest, _plan.Body.Mass, ref impulse);
                }
            }
        }
    }
}
#endif
