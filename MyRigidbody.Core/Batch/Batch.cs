#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Many bodies that differ in their starts alone, stepped several at a time in the lanes of the processor and on
    /// several threads. Each comes to the bits it would have alone in a <see cref="Simulation"/>.
    /// </summary>
    /// <remarks>
    /// In lanes go <c>Exact</c>, <c>Exact4</c>, <c>Exact6</c> and <c>LabEuler</c> with pushes that read nothing but the time;
    /// any other rule or push is computed body by body. Bodies that coast are computed when somebody looks. Once there is
    /// room, nothing here allocates. Not to be called by two threads at the same time.
    /// </remarks>
    public sealed class Batch
    {
        private const int MostThreads = 1024;

        // to keep all bodies takes about as long as to look at them
        private const long StepsBetweenCopies = 16 * Parts.StepsBetweenLooks;

        private readonly BodyPlan _plan;
        private readonly BodyDescription _like;
        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Places _places = new Places();
        private readonly Parts _parts;
        private readonly Retrace _retrace;
        private readonly bool[] _coasts;
        private readonly bool _isSteered;
        private int _stretch, _capacity = 16;
        private bool _isSuspect;
        private Turnstile _turnstile;

        /// <summary>No bodies yet, of one kind.</summary>
        /// <param name="body">What every body is, but for its start. Nothing that is changed in it later changes the batch.</param>
        /// <param name="steps">How time is divided.</param>
        /// <param name="mayLeaveOut">Whether bodies that coast may wait until somebody looks. What differs from body to body is not left out.</param>
        public Batch(BodyDescription body, TimeSteps steps, Omissions mayLeaveOut = Omissions.Coasting)
        {
            Guard.NotNull(body, nameof(body));
            Guard.NotNull(steps, nameof(steps));
            _plan = new BodyPlan(body, steps, mayLeaveOut & Omissions.Coasting);
            _like = _plan.Body;
            _crowd = Crowds.Choose(_plan);
            _coasters = new Coasters(_crowd, steps);
            _coasts = new bool[_plan.Stretches.Count];
            _retrace = new Retrace(_plan, _crowd, _coasters, _places, _coasts);
            Reserve(_capacity);
            _like.Start = BodyState.AtRest;
            _crowd.Start(0, _like);
            for (int i = 0; i < _coasts.Length; i++)
            {
                StretchPlan stretch = _plan.Stretches[i];
                bool isPushed = (stretch.Does & (PushTraits.Moves | PushTraits.Turns)) != 0;
                _coasts[i] = _plan.MayCoast && !isPushed && _crowd.HasClosedForm(0, stretch.Coasting);
                foreach (PushEffect effect in stretch.Pushes)
                    _isSteered |= effect.Push is IInput;
            }

            _parts = new Parts(_plan, _crowd, _coasters, _retrace, _places);
            Threads = Environment.ProcessorCount;
            Begin();
        }

        /// <summary>How many bodies there are.</summary>
        public int Count => _places.Count;

        /// <summary>Every body's number is below this.</summary>
        public int EndOfIds => _places.EndOfIds;

        /// <summary>How many steps are done.</summary>
        public long StepsDone { get; private set; }

        /// <summary>Time since the start, s.</summary>
        public double Time => _plan.Steps.StartOf(StepsDone);

        /// <summary>How many threads may step at a time, from 1 to 1024; the result is the same for any number.</summary>
        public int Threads
        {
            get => _parts.Threads;
            set
            {
                if (value < 1 || value > MostThreads)
                    throw Guard.Refused(nameof(Threads), value, "must be from 1 to " + MostThreads);

                _parts.Threads = value;
            }
        }

        /// <summary>Where a body is and how it moves now.</summary>
        /// <param name="id">The number that <see cref="Add(in BodyState)"/> gave it.</param>
        public BodyState this[int id]
        {
            get
            {
                int place = _places.Of(id);
                Follow(place);
                BodyState state = _crowd.StateOf(place);
                if (state.HasFiniteSquares)
                    return state;

                long end = StepsDone;
                int first = place - place % _crowd.Width;
                Exception lost = _retrace.Find(_parts.Own, place, ref end);
                _retrace.Go(_parts.Own, first, first + _crowd.Width, StepsDone);
                throw lost ?? new StateOverflowException(_plan, Math.Max(0, StepsDone - 1), id);
            }
        }

        /// <summary>True while a body has been put to sleep.</summary>
        /// <param name="id">The number that <see cref="Add(in BodyState)"/> gave it.</param>
        public bool IsAsleep(int id) => _crowd.IsAsleep(_places.Of(id));

        /// <summary>Adds a body that starts now. Its number is its own until it is removed, and may then be another's.</summary>
        public int Add(in BodyState start)
        {
            _like.Start = start;
            return Add();
        }

        /// <summary>Adds a body that starts now, with an angular velocity (rad/s) in body axes instead of the start's own.</summary>
        public int Add(in BodyState start, Vector3d angularVelocityInBody)
        {
            _like.Start = start;
            _like.AngularVelocityInBody = Guard.Finite(angularVelocityInBody, nameof(angularVelocityInBody));
            return Add();
        }

        private int Add()
        {
            _like.Check();
            int place = Count;
            if (place == _capacity)
                Reserve(2 * _capacity);

            if (place % _crowd.Width != 0)
                Follow(place);

            _crowd.Start(place, _like);
            _retrace.Keep(place, place + 1, StepsDone);
            if (_coasts[_stretch])
                _coasters.Enter(place, place + 1, StepsDone);

            return _places.Add();
        }

        /// <summary>Removes a body.</summary>
        /// <param name="id">The number that <see cref="Add(in BodyState)"/> gave it.</param>
        public void Remove(int id)
        {
            int place = _places.Of(id), last = Count - 1;
            Follow(place);
            Follow(last);
            _crowd.Move(last, place);
            _retrace.Move(last, place);
            _coasters.Move(last, place, StepsDone);

            _places.Remove(id);
        }

        /// <summary>Writes the state of every body to where its number says; what no body has for its number stays as it is.</summary>
        /// <param name="states">At least <see cref="EndOfIds"/> of them.</param>
        /// <exception cref="StateOverflowException">A body has run away since somebody looked: it is named, with the step.</exception>
        public void Read(Memory<BodyState> states)
        {
            if (states.Length < EndOfIds)
                throw Guard.Refused(nameof(states), states.Length, "must have room for " + EndOfIds + " states");

            _parts.Read(StepsDone, states);
            if (!_parts.AnyFailed)
                return;

            long step = StepsDone;
            Exception lost = _parts.FindLost(ref step);
            _parts.GoBack(StepsDone);
            throw lost ?? new StateOverflowException(_plan, Math.Max(0, StepsDone - 1), _places.IdAt(_crowd.FirstLost(0, Count)));
        }

        /// <summary>A number of steps of all bodies; the same bits as that many single ones.</summary>
        /// <remarks>
        /// Bodies are looked at after every 64th step, after a call of at least so many, and when they are read; so it may be
        /// a later call that finds one lost. It is the step and the body that are named, as a <see cref="Simulation"/> would, and
        /// all bodies go back to before that step, or to where the call began if that is later. For that each is kept once more, as it
        /// was at most 1024 steps before, and effects are asked again about those steps: they are functions of time and state. What a
        /// program changes between steps belongs into a <see cref="Hand"/> or a <see cref="Keyboard"/>; with one, all bodies are looked
        /// at and kept in every call.
        /// </remarks>
        /// <exception cref="StateOverflowException">The step of a body did not lead to a finite state. The others can go on once it is removed.</exception>
        /// <exception cref="BrokenEffectException">An effect gave a force that is not finite, or threw an exception.</exception>
        /// <exception cref="InvalidOperationException">Another thread steps the batch.</exception>
        public void Step(long count = 1)
        {
            long left = _plan.Steps.Count - StepsDone;
            if (count < 0 || count > left)
                throw Guard.Refused(nameof(count), count, "must be from 0 to the " + left + " steps that are left");

            _turnstile.Enter("batch of", _like.Name);
            try
            {
                Advance(StepsDone + count);
            }
            finally
            {
                _turnstile.Leave();
            }
        }

        private void Advance(long end)
        {
            long began = StepsDone;
            if (_isSteered && !_coasts[_stretch])
                _parts.Keep(began);

            while (StepsDone < end)
            {
                bool coasts = _coasts[_stretch];
                long endOfStretch = _plan.Stretches[_stretch].End, stop = Math.Min(end, endOfStretch);
                bool isNext = stop == endOfStretch && _stretch + 1 < _coasts.Length;
                if (coasts && stop == endOfStretch)
                    _parts.Follow(stop);

                if (!coasts)
                {
                    stop = Math.Min(stop, (StepsDone / StepsBetweenCopies + 1) * StepsBetweenCopies);
                    isNext &= stop == endOfStretch;
                    _parts.Step(StepsDone, stop, looksAtStop: _isSuspect || _isSteered || (isNext && _coasts[_stretch + 1]));
                }

                if (_parts.AnyFailed)
                    GoBack(began, stop);

                _isSuspect = false;
                StepsDone = stop;
                if (isNext)
                {
                    _stretch++;
                    Begin();
                }

                if (!coasts && !_coasts[_stretch] && stop % StepsBetweenCopies == 0)
                    _parts.Keep(stop);
            }
        }

        /// <summary>Where a body could not go on, all go back to before that step, or to where the call began.</summary>
        private void GoBack(long began, long stop)
        {
            long step = stop;
            Exception failure = _parts.FindLost(ref step);
            long back = failure == null ? stop : Math.Max(began, step);
            _parts.GoBack(back);
            if (failure == null)
                return;

            StepsDone = back;
            _stretch = _retrace.StretchOf(back);
            _parts.Begin(_stretch, _coasts[_stretch]);
            _crowd.Forget(0, _capacity);
            _isSuspect = true;
            throw failure;
        }

        private void Begin()
        {
            _crowd.Forget(0, _capacity);
            bool coasts = _coasts[_stretch], coasted = _stretch > 0 && _coasts[_stretch - 1];
            _parts.Begin(_stretch, coasts);
            if (coasts)
                _coasters.Begin(_stretch, _plan.Stretches[_stretch].Coasting);

            if (coasts || coasted)
                _parts.Keep(StepsDone);
        }

        private void Reserve(int capacity)
        {
            _crowd.Reserve(capacity);
            _coasters.Reserve(capacity);
            _retrace.Reserve(capacity);
            _places.Reserve(capacity);
            _capacity = capacity;
        }

        /// <summary>Brings the body in a place, and those that are stepped with it, to now.</summary>
        private void Follow(int place)
        {
            if (!_coasts[_stretch])
                return;

            int first = place - place % _crowd.Width;
            _coasters.Follow(_parts.Own, first, first + _crowd.Width, StepsDone);
        }
    }
}
#endif
