#if NET
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Moves many bodies that share a plan, several at a time in the vector lanes of the processor and on several threads. Each
    /// body gets the same bits as alone (<see cref="Mover{TIntegrator}"/>).
    /// </summary>
    /// <remarks>
    /// Lanes compute <c>Exact</c>, <c>Exact4</c>, <c>Exact6</c> and <c>LabEuler</c> with pushes that read only the time;
    /// any other integrator or push is computed body by body. Nothing allocates once the storage is large enough.
    /// </remarks>
    internal sealed partial class Batch : Mover
    {
        private const int LeastCapacity = 8;

        private readonly Clock _clock;
        private readonly BodyDescription _like;
        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Places _places = new Places();
        private readonly Parts _parts;
        private readonly Retrace _retrace;
        private readonly Dictionary<Body, Load> _loads = new Dictionary<Body, Load>();
        // for each stretch, whether bodies coast in it
        private readonly bool[] _coasts;
        private readonly bool _isSteered;
        private int _stretch, _capacity, _threads;
        private long _step;

        /// <summary>A batch without bodies.</summary>
        /// <param name="kind">The kind of its bodies.</param>
        /// <param name="plan">Their plan.</param>
        /// <param name="clock">The clock of the simulation.</param>
        public Batch(Kind kind, BodyPlan plan, Clock clock) : base(plan)
        {
            Kind = kind;
            _clock = clock;
            _like = plan.Body.Copy(plan.Body.Name, plan.Body.Mass);
            _like.Start = BodyState.AtRest;
            _crowd = Crowds.Choose(plan);
            _coasters = new Coasters(_crowd, plan.Steps);
            _coasts = new bool[plan.Stretches.Count];
            _retrace = new Retrace(plan, _crowd, _coasters, _places, _coasts);
            _parts = new Parts(plan, _crowd, _coasters, _retrace, _places);
            Reserve(LeastCapacity);
            _crowd.Start(0, _like);
            for (int i = 0; i < _coasts.Length; i++)
            {
                StretchPlan stretch = plan.Stretches[i];
                bool isPushed = (stretch.Does & (EffectTraits.Moves | EffectTraits.Turns)) != 0;
                _coasts[i] = plan.MayCoast && !isPushed && _crowd.HasClosedForm(0, stretch.Coasting);
                foreach (PushEffect effect in stretch.Pushes)
                    _isSteered |= effect.Push is IInput;
            }
        }

        /// <summary>The kind of its bodies.</summary>
        public Kind Kind { get; }

        /// <summary>The number of bodies.</summary>
        public int Count => _places.Count;

        public override bool HasMany => true;

        /// <summary>The largest number of threads that step at a time; it does not change the result.</summary>
        public int Threads
        {
            set
            {
                _threads = value;
                // for few bodies, starting threads costs more than they save
                _parts.Threads = _capacity > Parts.BodiesOfPart ? value : 1;
            }
        }

        /// <summary>Adds a body that starts now.</summary>
        public void Add(Body body, in BodyState start, Vector3d? inBody)
        {
            if (Count == 0)
                Awake();

            int place = Count;
            if (place == _capacity)
                Reserve(2 * _capacity);

            if (place % _crowd.Width != 0)
                Follow(place);

            _like.Start = start;
            if (inBody != null)
                _like.AngularVelocityInBody = inBody.Value;

            _crowd.Start(place, _like);
            _places.Add(body);
            body.Mover = this;
            Keep(place);
        }

        public override bool Remove(Body body)
        {
            int place = body.Place, last = Count - 1;
            Follow(place);
            Follow(last);
            _crowd.Move(last, place);
            _retrace.Move(last, place);
            _coasters.Move(last, place, _step);
            _places.Remove(place);
            _loads.Remove(body);
            return last == 0;
        }

        public override BodyState StateOf(Body body)
        {
            Follow(body.Place);
            BodyState state = _crowd.StateOf(body.Place);
            return state.HasFiniteSquares ? state : throw Lost(body.Place);
        }

        public override int Read(BodyState[] states)
        {
            _parts.Read(_step, states);
            return _parts.AnyFailed ? throw Lost() : Count;
        }

        public override bool IsAsleep(Body body) => _crowd.IsAsleep(body.Place);

        public override bool IsDormant(Body body) => _coasts[_stretch] && _coasters.HasForm(body.Place) && !_loads.ContainsKey(body) && !Gives;

        public override void Push(Body body, in Wrench impulse)
        {
            Follow(body.Place);
            if (!_crowd.Push(this, body.Place, impulse))
                throw Lost(body.Place);

            Keep(body.Place);
        }

        public override void Set(Body body, in BodyState state)
        {
            Follow(body.Place);
            _like.Start = state;
            _crowd.Start(body.Place, _like);
            Keep(body.Place);
        }

        public override void Add(Body body, in Load load)
        {
            StateOf(body);
            if (!_loads.TryGetValue(body, out Load sum))
                sum = new Load { Step = _step };

            _loads[body] = sum.With(load, body.Name);
        }

        public override LoneMover Alone(Body body)
        {
            int place = body.Place;
            Follow(place);
            long since = _retrace.Since(place);
            bool coasts = _coasts[_stretch] && _coasters.HasForm(place) && !Gives;
            LoneMover alone = _crowd.Alone(Plan.For(body.Name), _clock, place, since, coasts ? _stretch : _retrace.StretchOf(since), _stretch, coasts);
            if (_loads.TryGetValue(body, out Load load))
                alone.Add(body, load);

            return alone;
        }

        public override object Save() => new Saved
        {
            Crowd = _crowd.Save(),
            Coasters = _coasters.Save(),
            Since = _retrace.Save(),
            Bodies = _places.Save(),
            Loads = new Dictionary<Body, Load>(_loads),
            Stretch = _stretch,
            Step = _step,
            Capacity = _capacity,
        };

        public override void Restore(object saved)
        {
            Saved from = (Saved)saved;
            Clear();
            _capacity = from.Capacity;
            _places.Reserve(_capacity);
            _crowd.Restore(from.Crowd);
            _coasters.Restore(from.Coasters);
            _retrace.Restore(from.Since);
            _places.Restore(from.Bodies);
            foreach (KeyValuePair<Body, Load> load in from.Loads)
                _loads.Add(load.Key, load.Value);

            _step = _stayed = from.Step;
            Enter(from.Stretch);
        }

        /// <summary>Removes all bodies.</summary>
        public void Clear()
        {
            _places.Clear();
            _loads.Clear();
            _coasters.Clear();
            _retrace.Clear();
        }

        private void Reserve(int capacity)
        {
            _crowd.Reserve(capacity);
            _coasters.Reserve(capacity);
            _retrace.Reserve(capacity);
            _places.Reserve(capacity);
            _capacity = capacity;
            if (_threads > 0)
                Threads = _threads;
        }

        /// <summary>Brings the body in a place, and those that are stepped with it, to the present step.</summary>
        private void Follow(int place)
        {
            if (!_coasts[_stretch])
                return;

            int first = place - place % _crowd.Width;
            _coasters.Follow(_parts.Own, first, first + _crowd.Width, _step);
        }

        /// <summary>Stores the present state of a body, which may coast from here.</summary>
        private void Keep(int place)
        {
            _retrace.Keep(place, place + 1, _step);
            if (_coasts[_stretch])
                _coasters.Enter(place, place + 1, _step);
        }

        /// <summary>The exception that says why a body has no state.</summary>
        private Exception Lost(int place)
        {
            long end = _step;
            int first = place - place % _crowd.Width;
            Exception lost = _retrace.Find(_parts.Own, place, ref end);
            _retrace.Go(_parts.Own, first, first + _crowd.Width, _step);
            return lost ?? new StateOverflowException(Plan, Math.Max(0, _step - 1), _places[place]);
        }

        private sealed class Saved
        {
            public object Crowd;
            public long[][] Coasters;
            public long[] Since;
            public Body[] Bodies;
            public Dictionary<Body, Load> Loads;
            public int Stretch, Capacity;
            public long Step;
        }
    }
}
#endif
