using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A body that moves by one rule, with a stretch of time for every sum of effects that acts on it. Where it coasts
    /// the state follows the clock only when somebody looks.
    /// </summary>
    internal sealed class MovingBody<TIntegrator> : Body where TIntegrator : struct, IIntegrator
    {
        // a copy costs as much as the shortest step; from one of a body that nothing pushes the way on is known
        private const long StepsBetweenCopies = 1024;

        private readonly Stretch<TIntegrator>[] _stretches;
        private readonly TimeSteps _steps;
        private readonly Clock _clock;
        private Moment _now, _before;

        public MovingBody(BodyPlan plan, Clock clock) : base(plan)
        {
            _clock = clock;
            _steps = plan.Steps;
            _stretches = StretchBuilder<TIntegrator>.Bind(plan, isWatched: false);
            _now.Motion.Start(new Beginning(plan.Body));
            Settle();
            _before = _now;
        }

        public override BodyState State
        {
            get
            {
                CatchUp();
                BodyState state = _now.Motion.State;
                return state.HasFiniteSquares ? state : throw new StateOverflowException(Plan, Math.Max(0, _now.Step - 1));
            }
        }

        public override bool IsAsleep => _now.Motion.IsAsleep;

        public override bool IsDormant => _now.IsDormant;

        internal override long WakesAt => _stretches[_now.Stretch].End;

        internal override long Advance(long end, ref Exception failure)
        {
            if (Plan.IsPushed || _now.Step - _before.Step >= StepsBetweenCopies)
                _before = _now;

            try
            {
                Run(_stretches, end);
                if (_now.Motion.IsFinite)
                    return end;
            }
            catch (Exception)
            {
                // found again below, step by step
            }

            Return();
            return Retrace(end, ref failure);
        }

        internal override void GoBack()
        {
            Return();
            if (!Plan.IsPushed)
                Run(_stretches, _clock.Step);
        }

        private void Return()
        {
            _now = _before;
            foreach (Stretch<TIntegrator> stretch in _stretches)
                stretch.Forget();
        }

        internal override object Save()
        {
            CatchUp();
            return new Saved { Now = _now, Anchor = _stretches[_now.Stretch].Anchor };
        }

        internal override void Restore(object saved)
        {
            Saved from = (Saved)saved;
            _before = from.Now;
            Return();
            _stretches[_now.Stretch].Anchor = from.Anchor;
        }

        private void Run(Stretch<TIntegrator>[] stretches, long end)
        {
            while (_now.Step < end)
            {
                Stretch<TIntegrator> stretch = stretches[_now.Stretch];
                long stop = Math.Min(end, stretch.End);
                if (_now.IsDormant && stop < stretch.End)
                    return;

                if (_now.IsDormant)
                    _stretches[_now.Stretch].Coast(ref _now.Motion, _steps, _now.Anchored, _now.Step, stop);
                else
                    stretch.Run(ref _now.Motion, _steps, _now.Step, stop);

                _now.Step = stop;
                _now.IsDormant = false;
                if (stop == stretch.End && _now.Stretch + 1 < stretches.Length)
                    _now.Stretch++;

                Settle();
            }
        }

        /// <summary>
        /// Lets the body lie where nothing has to be computed until somebody looks: from the start of a stretch, or asleep, but
        /// not wherever a call happens to end, or the bits would depend on the calls.
        /// </summary>
        private void Settle()
        {
            Stretch<TIntegrator> stretch = _stretches[_now.Stretch];
            bool isPlace = _now.Step == Plan.Stretches[_now.Stretch].First || _now.Motion.IsAsleep;
            if (isPlace && Plan.MayCoast && stretch.LetsCoast(ref _now.Motion, _steps, _now.Step))
            {
                _now.IsDormant = true;
                _now.Anchored = _now.Step;
                stretch.Anchor = _now.Motion;
            }
        }

        private void CatchUp()
        {
            long step = _clock.Step;
            if (!_now.IsDormant || _now.Step >= step)
                return;

            _stretches[_now.Stretch].Coast(ref _now.Motion, _steps, _now.Anchored, _now.Step, step);
            _now.Step = step;
            if (_now.Motion.IsFinite)
                return;

            // back to where it began to coast, so that it is said again to whoever looks next
            _now.Motion = _stretches[_now.Stretch].Anchor;
            _now.Step = _now.Anchored;
            throw new StateOverflowException(Plan, LastFinite(_now, step));
        }

        /// <summary>The last of the steps up to one that has no finite state at which a body that coasts still has one.</summary>
        private long LastFinite(in Moment coasting, long end)
        {
            Stretch<TIntegrator> stretch = _stretches[coasting.Stretch];
            long low = coasting.Anchored, high = end;
            while (high - low > 1)
            {
                long middle = low + (high - low) / 2;
                TIntegrator motion = stretch.Anchor;
                stretch.Forget();
                stretch.Coast(ref motion, _steps, coasting.Anchored, coasting.Anchored, middle);
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
            while (_now.Step < end && !(_now.IsDormant && WakesAt > end))
            {
                Moment last = _now;
                long reached = _now.Step;
                try
                {
                    // a dormant body goes as far as it coasts, no push acts there; who looked may have brought it to the end of that
                    Run(watched, _now.IsDormant ? Math.Max(WakesAt, reached + 1) : reached + 1);
                    if (_now.Motion.IsFinite)
                        continue;

                    reached = last.IsDormant && last.Step < _now.Step - 1 ? LastFinite(last, _now.Step) : _now.Step - 1;
                    failure = new StateOverflowException(Plan, reached);
                }
                catch (Exception found)
                {
                    failure = found;
                }

                GoBack();
                // what coasts is not looked at in every step, so it may have been lost before this call
                return Math.Max(reached, _clock.Step);
            }

            return end;
        }

        /// <summary>All that changes in a body.</summary>
        private struct Moment
        {
            public TIntegrator Motion;
            public long Step, Anchored;
            public int Stretch;
            public bool IsDormant;
        }

        private sealed class Saved
        {
            public Moment Now;
            public TIntegrator Anchor;
        }
    }
}
