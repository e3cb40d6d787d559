using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Bodies in motion. They come and go, are pushed and changed between two steps; nothing of that may be done by an effect while
    /// a step is taken.
    /// </summary>
    public sealed partial class Simulation
    {
        private const int MostThreads = 1024;

        private readonly List<Body> _bodies = new List<Body>();
        // those that are moved together, and there are any of
        private readonly List<Mover> _crowds = new List<Mover>();
        private readonly Clock _clock;
        private int _threads = Math.Min(Environment.ProcessorCount, MostThreads);
        private Turnstile _turnstile;

        /// <summary>Reads the scene once: every body gets the sum of what acts on it and the step made for that sum.</summary>
        /// <param name="scene">The scene; nothing that is changed in it later changes the simulation.</param>
        public Simulation(SceneDescription scene) : this(scene, Omissions.All) { }

        /// <summary>One that leaves out no more than it may, so that one can measure what that saves.</summary>
        internal Simulation(SceneDescription scene, Omissions mayLeaveOut)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            MayLeaveOut = mayLeaveOut;
            _clock = new Clock(scene.Steps);
            foreach (BodyDescription body in scene.Bodies)
                Enter(new Body(this) { Mover = Moving(body, MayLeaveOut) });
        }

        /// <summary>Bodies that move in steps of one division of time; none at first, if none is named.</summary>
        public Simulation(TimeSteps steps, params BodyDescription[] bodies) : this(new SceneDescription("simulation", string.Empty, steps, bodies)) { }

        /// <summary>What it began with.</summary>
        public SceneDescription Scene { get; }

        /// <summary>The bodies, in the order in which they came; the last takes the place of one that is removed.</summary>
        public IReadOnlyList<Body> Bodies => _bodies;

        /// <summary>How many steps are done.</summary>
        public long StepsDone => _clock.Step;

        /// <summary>
        /// How many threads may step bodies that were added with one description, from 1 to 1024; as many as there are processors at
        /// first. The result is the same for any number; on .NET Standard it is one thread always.
        /// </summary>
        public int Threads
        {
            get => _threads;
            set
            {
                MayBeChanged();
                _threads = value >= 1 && value <= MostThreads ? value : throw Guard.Refused(nameof(Threads), value, "must be from 1 to " + MostThreads);
                Distribute();
            }
        }

        /// <summary>Time since the start, s.</summary>
        public double Time => _clock.Steps.StartOf(StepsDone);

        internal Omissions MayLeaveOut { get; }

        /// <summary>
        /// Adds a body, which starts now. Many that are added with one description are stored and stepped together, several at a time
        /// and on several threads; each moves to the same bits as it would alone.
        /// </summary>
        /// <param name="description">What it is; nothing that is changed in it later changes the body. Names may repeat.</param>
        public Body Add(BodyDescription description) => Add(Guard.NotNull(description, nameof(description)), description.Start, description.GivenInBody);

        /// <summary>Adds a body, which starts now, in a state of its own.</summary>
        /// <param name="description">What it is, but for its start.</param>
        /// <param name="start">Where it starts.</param>
        public Body Add(BodyDescription description, in BodyState start) => Add(Guard.NotNull(description, nameof(description)), start, null);

        /// <summary>
        /// Brings back a body that was removed: what it was last, from another start. One that was stored with others is so again, and
        /// nothing is allocated.
        /// </summary>
        /// <param name="removed">A body of this simulation.</param>
        /// <param name="start">Where it starts.</param>
        public void Add(Body removed, in BodyState start)
        {
            if (Guard.NotNull(removed, nameof(removed)).Simulation != this || !removed.IsRemoved)
                throw new ArgumentException("removed: \"" + removed.Name + "\" must be a body that was removed from this simulation", nameof(removed));

            MayBeChanged();
            removed.Plan.Asked.Check(start);
            bool isTogether = false;
            AddTogether(removed, removed.Mover, start, ref isTogether);
            if (!isTogether)
                removed.Mover = Moving(At(removed.Plan.Asked, start, null), MayLeaveOut);

            Enter(removed);
        }

        /// <summary>Removes a body. Its handle can be asked for its name and its plan, and brought back, and for nothing else.</summary>
        public void Remove(Body body)
        {
            Mine(body);
            MayBeChanged();
            Part(body.Mover, body);
            Leave(body);
        }

        /// <summary>
        /// The states of all bodies now, in the order of <see cref="Bodies"/>: those of <see cref="Body.State"/>, and where many are stored
        /// together several at a time.
        /// </summary>
        /// <param name="states">Where they go; what is behind the last stays.</param>
        /// <exception cref="StateOverflowException">A body has none; those that were read before it are there.</exception>
        public void ReadStates(BodyState[] states)
        {
            if (Guard.NotNull(states, nameof(states)).Length < _bodies.Count)
                throw Guard.Refused(nameof(states), states.Length, "must have room for the states of " + _bodies.Count + " bodies");

            MayBeChanged();
            int read = 0;
            foreach (Mover crowd in _crowds)
                read += crowd.Read(states);

            for (int i = 0; i < _bodies.Count && read < _bodies.Count; i++)
            {
                if (_bodies[i].Mover is LoneMover alone)
                    states[i] = alone.StateOf(_bodies[i]);
            }
        }

        /// <summary>All that a later <see cref="Restore"/> needs to go on from here to the same bits, and with the same bodies.</summary>
        public SavedSimulation Save()
        {
            MayBeChanged();
            return new SavedSimulation(this, _clock, _rest, _bodies.ConvertAll(body => new SavedBody(body)), _crowds.ConvertAll(crowd => new SavedCrowd(crowd)));
        }

        /// <summary>
        /// Goes back, or on, to where the simulation was when it was saved. Bodies that have been removed since come back with their
        /// handles; bodies that have come since are removed.
        /// </summary>
        public void Restore(SavedSimulation saved)
        {
            if (Guard.NotNull(saved, nameof(saved)).Owner != this)
                throw new ArgumentException("saved: must come from the same simulation", nameof(saved));

            MayBeChanged();
            while (_bodies.Count > 0)
                Leave(_bodies[_bodies.Count - 1]);

            LayDown();
            _clock.Steps.Division = saved.Division;
            _clock.Step = saved.StepsDone;
            _clock.LastLength = saved.LastLength;
            _rest = saved.Rest;
            RestoreCrowds(saved);
            foreach (SavedBody body in saved.Bodies)
            {
                body.Restore();
                Enter(body.Body);
            }
        }

        /// <summary>Refuses what an effect would do to the simulation in which it acts.</summary>
        internal void MayBeChanged()
        {
            _turnstile.Enter("simulation", Scene.Name);
            _turnstile.Leave();
        }

        /// <summary>From now on a body moves after another description.</summary>
        internal void Plan(Body body, BodyDescription description, in BodyState state, Omissions mayLeaveOut)
        {
            LoneMover last = Alone(body.Mover, body);
            bool isLoaded = last.Load.Step == StepsDone;
            double ratio = description == last.Plan.Asked ? last.Plan.MassRatioAt(StepsDone) : 1;
            LoneMover next = Moving(At(description, state, null), isLoaded ? mayLeaveOut & ~last.Load.Needs : mayLeaveOut, ratio);
            last.Arrive(mayCoast: true);
            next.Last = last.Last;
            if (isLoaded)
                next.Add(body, last.Load);

            body.Mover = next;
        }

        /// <summary>The mover of a body by itself. A body that is stored with others leaves them.</summary>
        internal LoneMover Alone(Mover mover, Body body)
        {
            if (mover is LoneMover alone)
                return alone;

            alone = mover.Alone(body);
            Part(mover, body);
            body.Mover = alone;
            Sort(body);
            return alone;
        }

        private void Part(Mover mover, Body body)
        {
            if (mover.Remove(body))
                _crowds.Remove(mover);
        }

        private Body Add(BodyDescription description, in BodyState start, Vector3d? inBody)
        {
            MayBeChanged();
            Body body = new Body(this);
            bool isTogether = false;
            AddTogether(body, description, start, inBody, ref isTogether);
            if (!isTogether)
                body.Mover = Moving(At(description, start, inBody), MayLeaveOut);

            Enter(body);
            return body;
        }

        private static BodyDescription At(BodyDescription description, in BodyState start, Vector3d? inBody)
        {
            BodyDescription at = description.Copy(description.Name, description.Mass);
            at.Start = start;
            if (inBody != null)
                at.AngularVelocityInBody = inBody.Value;

            return at;
        }

        private LoneMover Moving(BodyDescription description, Omissions mayLeaveOut, double massRatio = 1)
        {
            BodyPlan plan = new BodyPlan(description, _clock.Steps, mayLeaveOut, StepsDone, massRatio);
            return plan.Rule.Build(plan, _clock);
        }

        private void Enter(Body body)
        {
            body.Index = _bodies.Count;
            _bodies.Add(body);
            Sort(body);
        }

        private void Leave(Body body)
        {
            _dormant.Remove(body);
            Body last = _bodies[_bodies.Count - 1];
            _bodies[last.Index = body.Index] = last;
            _bodies.RemoveAt(_bodies.Count - 1);
            body.Index = -1;
            _clock.SomeRest |= body.IsStepped;
        }

        partial void AddTogether(Body body, BodyDescription description, in BodyState start, Vector3d? inBody, ref bool isTogether);

        partial void AddTogether(Body body, Mover mover, in BodyState start, ref bool isTogether);

        partial void RestoreCrowds(SavedSimulation saved);

        partial void Distribute();

        private void Mine(Body body)
        {
            int index = Guard.NotNull(body, nameof(body)).Index;
            if (index < 0 || index >= _bodies.Count || _bodies[index] != body)
                throw new ArgumentException("body: \"" + body.Name + "\" is not in this simulation", nameof(body));
        }
    }
}
