using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Moves a body by one integrator, with a stretch of time for every sum of effects on it. The state of a body that coasts is
    /// computed only when it is read.
    /// </summary>
    internal sealed partial class Mover<TIntegrator> : LoneMover where TIntegrator : struct, IIntegrator
    {
        // a copy costs as much as the shortest step; without pushes the motion from any copy is known
        private const long StepsBetweenCopies = 1024;

        private readonly Stretch<TIntegrator>[] _stretches;
        private readonly Clock _clock;
        private Stretch<TIntegrator>[] _loaded;
        // copied from the plan, which is elsewhere in memory
        private readonly bool _isPushed, _givesImpulses;
        private Moment _now;
        // null until it can be needed
        private Kept<Moment> _before;
        private long _keptAt;

        public Mover(BodyPlan plan, Clock clock) : this(plan, clock, default(TIntegrator), clock.Step)
        {
            _now.Motion.Start(new Beginning(plan.Body));
            Settle(isPlace: true);
            Keep();
        }

        /// <summary>The mover of a body that was stored with others.</summary>
        /// <param name="plan">Their plan.</param>
        /// <param name="clock">The clock of the simulation.</param>
        /// <param name="now">The present state of the body.</param>
        /// <param name="kept">Its state when it began to coast, or at an earlier step.</param>
        /// <param name="since">That step.</param>
        /// <param name="keptIn">The stretch of that step.</param>
        /// <param name="stretch">The present stretch.</param>
        /// <param name="coasts">Whether it coasts.</param>
        public Mover(BodyPlan plan, Clock clock, in TIntegrator now, in TIntegrator kept, long since, int keptIn, int stretch, bool coasts)
            : this(plan, clock, now, since)
        {
            _before = new Kept<Moment> { Value = new Moment { Motion = kept, Step = since, Anchored = since, Stretch = keptIn, IsDormant = coasts } };
            _keptAt = since;
            _now.Stretch = stretch;
            _now.IsDormant = coasts;
            if (coasts)
                _stretches[stretch].Anchor.Value = kept;
        }

        private Mover(BodyPlan plan, Clock clock, in TIntegrator now, long since) : base(plan)
        {
            _clock = clock;
            _isPushed = plan.IsPushed;
            _givesImpulses = plan.HasImpulses;
            _stretches = StretchBuilder<TIntegrator>.Bind(plan, isWatched: false);
            foreach (Stretch<TIntegrator> stretch in _stretches)
                stretch.Anchor = plan.MayCoast && !stretch.IsPushed ? new Kept<TIntegrator>() : null;

            _now = new Moment { Motion = now, Step = clock.Step, Anchored = since };
        }

        public override long WakesAt => _stretches[_now.Stretch].End;

        private bool IsLoaded => Load.Step == _now.Step;

        /// <summary>True where the next step begins with an impulse, which the state does not contain yet.</summary>
        private bool Gives => _givesImpulses && Plan.Stretches[_now.Stretch].GivesAt(_now.Step);

        public override BodyState StateOf(Body body)
        {
            CatchUp();
            BodyState state = _now.Motion.State;
            return state.HasFiniteSquares ? state : throw Lost(Math.Max(0, _now.Step - 1));
        }

        public override bool IsAsleep(Body body) => _now.Motion.IsAsleep;

        public override bool IsDormant(Body body) => _now.IsDormant;

        public override long Advance(long end, ref Exception failure)
        {
            if (_isPushed || IsLoaded || Last != null || _before == null || _now.Step - _keptAt >= StepsBetweenCopies)
                KeepNow();

            try
            {
                Run(_stretches, _loaded, end);
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

        public override void GoBack()
        {
            Return();
            if (_now.Step < _clock.Step)
                Run(_stretches, _loaded, _clock.Step);
        }

        public override BodyState Between(double alpha) => Remember().At(alpha);

        public override void Push(Body body, in Wrench impulse)
        {
            Arrive(mayCoast: true);
            Push(ref _now.Motion, impulse);
            Changed(mayCoast: true);
        }

        public override void Set(Body body, in BodyState state)
        {
            _now.Motion = default(TIntegrator);
            _now.Motion.Start(new Beginning(Plan.Body, state));
            _now.Step = _clock.Step;
            Last?.Jump(_clock.Step, _now.Motion.State);
            Forget();
            Changed(mayCoast: true);
        }

        public override void Add(Body body, in Load load)
        {
            Arrive(mayCoast: true);
            Load = (IsLoaded ? Load : new Load { Step = _now.Step }).With(load, body.Name);
            _now.IsDormant = false;
            KeepNow();
            _loaded = _loaded ?? StretchBuilder<TIntegrator>.Bind(Plan, isWatched: false, loaded: this);
        }

        public override void TakeOver(Mover last)
        {
            if (!(last is Mover<TIntegrator> same) || same.Plan.LeftOut != Plan.LeftOut)
                return;

            _now.Motion = same._now.Motion;
            Forget();
            Changed(mayCoast: true);
        }

        public override void Arrive(bool mayCoast)
        {
            CatchUp();
            // between the last two steps, the state before the change is drawn
            if (Last != null)
                Remember();

            Changed(mayCoast);
        }

        public override object Save()
        {
            CatchUp();
            return new Saved { Now = _now, Anchor = Anchor, Load = Load, Last = Last == null ? null : Remember().Copy() };
        }

        public override void Restore(object saved)
        {
            Saved from = (Saved)saved;
            Load = from.Load;
            Last = from.Last?.Copy();
            _now = from.Now;
            Forget();
            Keep();
            Anchor = from.Anchor;
        }

        private void Changed(bool mayCoast)
        {
            // a body that coasted to this step is still in the stretch that ends here
            if (_now.Step == WakesAt && _now.Stretch + 1 < _stretches.Length)
                _now.Stretch++;

            _now.IsDormant = false;
            Settle(mayCoast);
            Keep();
        }

        /// <summary>The state in which it began to coast, in a stretch where it may.</summary>
        private TIntegrator Anchor
        {
            get => _stretches[_now.Stretch].Anchor?.Value ?? default(TIntegrator);
            set
            {
                if (_stretches[_now.Stretch].Anchor is Kept<TIntegrator> anchor)
                    anchor.Value = value;
            }
        }

        private void Return()
        {
            _now = _before.Value;
            Forget();
        }

        private void Forget()
        {
            foreach (Stretch<TIntegrator> stretch in _stretches)
                stretch.Forget();
        }

        private void Run(Stretch<TIntegrator>[] stretches, Stretch<TIntegrator>[] loaded, long end)
        {
            while (_now.Step < end)
            {
                Stretch<TIntegrator> stretch = stretches[_now.Stretch];
                bool isLoaded = IsLoaded, gives = Gives;
                long stop = isLoaded || gives ? _now.Step + 1 : Math.Min(end, stretch.End);
                if (_now.IsDormant && stop < stretch.End)
                    return;

                if (gives)
                    Give(ref _now.Motion, Plan.Stretches[_now.Stretch]);

                if (isLoaded)
                    RunLoaded(stretch, loaded[_now.Stretch], stop);
                else if (_now.IsDormant)
                    _stretches[_now.Stretch].Coast(ref _now.Motion, _clock.Steps, _now.Anchored, _now.Step, stop);
                else
                    stretch.Run(ref _now.Motion, _clock.Steps, _now.Step, stop);

                _now.Step = stop;
                _now.IsDormant = false;
                bool isNext = stop == stretch.End && _now.Stretch + 1 < stretches.Length;
                if (isNext)
                    _now.Stretch++;

                Settle(isNext || isLoaded || gives);
            }
        }

        private void RunLoaded(Stretch<TIntegrator> stretch, Stretch<TIntegrator> loaded, long end)
        {
            loaded.PreparedFor = stretch.PreparedFor;
            loaded.Run(ref _now.Motion, _clock.Steps, _now.Step, end);
            stretch.PreparedFor = loaded.PreparedFor;
        }

        /// <summary>
        /// Makes the body dormant where nothing has to be computed until its state is read: from the start of a stretch, from a step in
        /// which the program changed it, or asleep. Not where a call happens to end, because bits would then depend on the calls.
        /// </summary>
        private void Settle(bool isPlace)
        {
            Stretch<TIntegrator> stretch = _stretches[_now.Stretch];
            if ((isPlace || _now.Motion.IsAsleep) && !IsLoaded && !Gives && Plan.MayCoast && stretch.LetsCoast(ref _now.Motion, _clock.Steps, _now.Step))
            {
                _now.IsDormant = _clock.SomeRest = true;
                _now.Anchored = _now.Step;
                stretch.Anchor.Value = _now.Motion;
            }
        }

        private void CatchUp() => CatchUp(_clock.Step);

        private void CatchUp(long step)
        {
            if (!_now.IsDormant || _now.Step >= step)
                return;

            _stretches[_now.Stretch].Coast(ref _now.Motion, _clock.Steps, _now.Anchored, _now.Step, step);
            _now.Step = step;
            if (_now.Motion.IsFinite)
                return;

            // back to where it began to coast, so that the next reader gets the same exception
            _now.Motion = Anchor;
            _now.Step = _now.Anchored;
            throw Lost(LastFinite(_now, step));
        }

        /// <summary>The part of a body that changes.</summary>
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
            public Load Load;
            public LastStep Last;
        }
    }
}
