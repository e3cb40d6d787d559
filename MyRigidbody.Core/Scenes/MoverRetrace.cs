using System;

namespace RigidBodyDynamics
{
    /// <summary>Repeats the steps of a body that could not go on, to find the step and the effect.</summary>
    internal sealed partial class Mover<TIntegrator>
    {
        /// <summary>The last step, before one without a finite state, at which a body that coasts has a finite one.</summary>
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

        /// <summary>Repeats the steps one by one, with every push watched, to find the failing push and step.</summary>
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
                    // a dormant body goes to the end of its coasting, where no push acts; reading its state may have brought it there already
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
                    // the load is dropped with the step, or every later step would fail, too
                    Load = Load.None;
                    Changed(mayCoast: true);
                }

                // a body that coasts is not tested in every step, so it may have been lost before this call
                return Math.Max(reached, _clock.Step);
            }

            return end;
        }

        // a body that coasts without end goes back to its anchor
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
