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
        // enough for a thread to be worth waking, few enough to stay in its cache
        private const int BodiesOfPart = 1024;
        private const int MostThreads = 1024;

        // to look whether all bodies still have states takes twice as long as the shortest step
        internal const long StepsBetweenLooks = 64;

        private readonly BodyPlan _plan;
        private readonly BodyDescription _like;
        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Places _places = new Places();
        private readonly Team<Stepper> _team;
        private readonly Losses _losses;
        private readonly bool[] _coasts;
        private int _stretch, _capacity = 16;
        private Task _task;
        private long _stop;
        private Memory<BodyState> _states;
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
            _losses = new Losses(_plan, _crowd);
            _coasts = new bool[_plan.Stretches.Count];
            Reserve(_capacity);
            _like.Start = BodyState.AtRest;
            _crowd.Start(0, _like);
            for (int i = 0; i < _coasts.Length; i++)
            {
                StretchPlan stretch = _plan.Stretches[i];
                bool isPushed = (stretch.Does & (PushTraits.Moves | PushTraits.Turns)) != 0;
                _coasts[i] = _plan.MayCoast && !isPushed && _crowd.HasClosedForm(0, stretch.Coasting);
            }

            Reserve(_capacity);
            _team = new Team<Stepper>(() => _crowd.NewStepper(_plan), Work);
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
            get => _team.Threads;
            set
            {
                if (value < 1 || value > MostThreads)
                    throw Guard.Refused(nameof(Threads), value, "must be from 1 to " + MostThreads);

                _team.Threads = value;
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
                return state.HasFiniteSquares ? state : throw new StateOverflowException(_plan, Math.Max(0, StepsDone - 1), id);
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
            _like.AngularVelocityInBody = angularVelocityInBody;
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
            _coasters.Move(last, place, StepsDone);

            _places.Remove(id);
        }

        /// <summary>Writes the state of every body to where its number says; what no body has for its number stays as it is.</summary>
        /// <param name="states">At least <see cref="EndOfIds"/> of them.</param>
        /// <exception cref="StateOverflowException">A body that coasted has run away since somebody looked.</exception>
        public void Read(Memory<BodyState> states)
        {
            if (states.Length < EndOfIds)
                throw Guard.Refused(nameof(states), states.Length, "must have room for " + EndOfIds + " states");

            _states = states;
            _losses.Forget();
            Do(Task.Read, StepsDone);
            _states = default(Memory<BodyState>);
            if (_losses.Any)
                throw _losses.Found(_places);
        }

        /// <summary>A number of steps of all bodies; the same bits as that many single ones.</summary>
        /// <remarks>An exception out of an effect comes out here; the bodies are then not all at the same step.</remarks>
        /// <exception cref="StateOverflowException">
        /// A body has run away: it is named. That is looked for after every 64th step, after a call of at least so many, and
        /// when a state is read. The others have done all the steps, and go on once it is removed.
        /// </exception>
        /// <exception cref="BrokenEffectException">An effect that reads nothing but the time gave a force that is not finite.</exception>
        /// <exception cref="InvalidOperationException">An effect stepped the batch, or another thread did.</exception>
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
            _losses.Forget();
            while (StepsDone < end)
            {
                long endOfStretch = _plan.Stretches[_stretch].End, stop = Math.Min(end, endOfStretch);
                if (!_coasts[_stretch])
                    Do(Task.Step, stop);
                else if (stop == endOfStretch)
                    Do(Task.Follow, stop);

                StepsDone = stop;
                if (stop == endOfStretch && _stretch + 1 < _coasts.Length)
                {
                    _stretch++;
                    Begin();
                }
            }

            if (_losses.Any)
                throw _losses.Found(_places);
        }

        private void Begin()
        {
            _crowd.Forget();
            if (!_coasts[_stretch])
                return;

            _coasters.Begin(_stretch, _plan.Stretches[_stretch].Coasting);
            Do(Task.Enter, StepsDone);
        }

        private void Reserve(int capacity)
        {
            _crowd.Reserve(capacity, Array.IndexOf(_coasts, true) >= 0);
            _coasters.Reserve(capacity);
            _places.Reserve(capacity);
            _capacity = capacity;
        }

        /// <summary>Brings the body in a place, and those that are stepped with it, to now.</summary>
        private void Follow(int place)
        {
            if (!_coasts[_stretch])
                return;

            int first = place - place % _crowd.Width;
            _coasters.Follow(_team.Own, first, first + _crowd.Width, StepsDone);
        }

        private void Do(Task task, long stop)
        {
            _task = task;
            _stop = stop;
            _team.Do((Count + BodiesOfPart - 1) / BodiesOfPart);
        }

        private void Work(Stepper stepper, int part)
        {
            int from = part * BodiesOfPart, to = Math.Min(Count, from + BodiesOfPart);
            int whole = (to + _crowd.Width - 1) / _crowd.Width * _crowd.Width;
            if (_task == Task.Step)
                Step(stepper, from, to, whole);
            else if (_task == Task.Enter)
                _coasters.Enter(from, to, _stop);
            else if (_coasts[_stretch])
                _coasters.Follow(stepper, from, whole, _stop);

            if (_task == Task.Follow || _task == Task.Read)
                _losses.Look(from, to, Math.Max(0, _stop - 1));

            if (_task != Task.Read)
                return;

            Span<BodyState> states = _states.Span;
            for (int i = from; i < to; i++)
                states[_places.IdAt(i)] = _crowd.StateOf(i);
        }

        private void Step(Stepper stepper, int from, int to, int whole)
        {
            for (long first = StepsDone, next; first < _stop; first = next)
            {
                next = first + Math.Min(_stop - first, StepsBetweenLooks - first % StepsBetweenLooks);
                stepper.Run(_stretch, from, whole, first, next);
                if (next % StepsBetweenLooks == 0 || next - StepsDone >= StepsBetweenLooks)
                    _losses.Look(from, to, next - 1);
            }
        }

        private enum Task
        {
            Step,
            Enter,
            Follow,
            Read,
        }
    }
}
#endif
