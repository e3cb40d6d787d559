using System;

namespace RigidBodyDynamics
{
    /// <summary>Where a body could not go on: the same steps once more, for the step and the effect.</summary>
    internal sealed partial class Mover<TIntegrator>
    {
        /// <summary>The last of the steps up to one that has no finite state at which a body that coasts still has one.</summary>
        private long LastFinite(in Moment coasting, long end)
        {
            Stretch<TIntegrator> stretch = _stretches[coasting.Stretch];
            long low = coasting.Anchored, high = end;
            while (high - low > 1)
            {
                long middle = low + (high - low) / 2;
                TIntegrator motion = stretch.Anchor.Value;
                stretch.Forget();
                stretch.Coast(ref motion, _clock.Steps, coasting.Anchored, coasting.Anchored, middle);
                if (motion.IsFinite)
                    low = middle;
                else
                    high = middle;
            }

            stretch.Forget();
            return low;
        }

        /// <summary>The same steps once more, one by one and with every push watched: which is it, and when.</summary>
        private long Retrace(long end, ref Exception failure)
        {
            Stretch<TIntegrator>[] watched = StretchBuilder<TIntegrator>.Bind(Plan, isWatched: true);
            Stretch<TIntegrator>[] loaded = _loaded == null ? null : StretchBuilder<TIntegrator>.Bind(Plan, isWatched: true, loaded: this);
            while (_now.Step < end && !(_now.IsDormant && WakesAt > end))
            {
                Moment last = _now;
                long reached = _now.Step;
                try
                {
                    // a dormant body goes as far as it coasts, no push acts there; who looked may have brought it to the end of that
                    Run(watched, loaded, _now.IsDormant ? Math.Max(WakesAt, reached + 1) : reached + 1);
                    if (_now.Motion.IsFinite)
                        continue;

                    reached = last.IsDormant && last.Step < _now.Step - 1 ? LastFinite(last, _now.Step) : _now.Step - 1;
                    failure = Lost(reached);
                }
                catch (Exception found)
                {
                    failure = found;
                }

                GoBack();
                if (failure is StateOverflowException && IsLoaded)
                {
                    // what was applied is refused with the step, or no step would ever be possible again
                    Load = Load.None;
                    Changed(mayCoast: true);
                }

                // what coasts is not looked at in every step, so it may have been lost before this call
                return Math.Max(reached, _clock.Step);
            }

            return end;
        }

        // a body that coasts for ever has its anchor to go back to
        private void Keep()
        {
            _keptAt = _now.Step;
            if (_before != null || !_now.IsDormant || _stretches.Length > 1)
                KeepNow();
        }

        private void KeepNow()
        {
            _before = _before ?? new Kept<Moment>();
            _before.Value = _now;
            _keptAt = _now.Step;
        }
    }
}
