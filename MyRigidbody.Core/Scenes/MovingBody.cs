using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A body that moves by one rule, with a stretch of time for every sum of effects that acts on it. Where it coasts
    /// the state follows the clock only when somebody looks.
    /// </summary>
    internal sealed class MovingBody<TIntegrator> : Body where TIntegrator : struct, IIntegrator
    {
        private readonly Stretch<TIntegrator>[] _stretches;
        private readonly TimeSteps _steps;
        private readonly Clock _clock;
        private Moment _now, _before;

        public MovingBody(BodyPlan plan, Clock clock) : base(plan)
        {
            _clock = clock;
            _steps = plan.Steps;
            _stretches = StretchBuilder<TIntegrator>.Bind(plan, isWatched: false);
            _now.Motion.Start(plan.Body);
            Settle();
        }

        public override BodyState State
        {
            get
            {
                CatchUp();
                return _now.Motion.State;
            }
        }

        public override bool IsAsleep => _now.Motion.IsAsleep;

        public override bool IsDormant => _now.IsDormant;

        internal override long WakesAt => _stretches[_now.Stretch].End;

        internal override long Advance(long end, ref Exception failure)
        {
            // a body on which nothing pushes is not held up by an effect, and need not know the way back
            if (Plan.IsPushed)
                _before = _now;

            try
            {
                Run(_stretches, end);
                if (!Plan.IsPushed || _now.Motion.IsFinite || !_before.Motion.IsFinite)
                    return end;
            }
            catch (Exception)
            {
                // found again below, step by step
            }

            GoBack();
            return Retrace(end, ref failure);
        }

        internal override void GoBack()
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
            GoBack();
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
        }

        /// <summary>The same steps once more, one by one and with every push watched: which is it, and when.</summary>
        private long Retrace(long end, ref Exception failure)
        {
            Stretch<TIntegrator>[] watched = StretchBuilder<TIntegrator>.Bind(Plan, isWatched: true);
            while (_now.Step < end && !(_now.IsDormant && WakesAt > end))
            {
                try
                {
                    // a dormant body goes as far as it coasts, no push acts there; who looked may have brought it to the end of that
                    long next = _now.Step + 1;
                    Run(watched, _now.IsDormant ? Math.Max(WakesAt, next) : next);
                }
                catch (Exception found)
                {
                    failure = found;
                    long reached = _now.Step;
                    GoBack();
                    return reached;
                }
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
