using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Bodies in motion. Between two steps a program can add, remove, push and change them; an effect may do none of this
    /// during a step.
    /// </summary>
    public sealed partial class Simulation
    {
        private const int MostThreads = 1024;

        private readonly List<Body> _bodies = new List<Body>();
        // the batches that have bodies
        private readonly List<Mover> _crowds = new List<Mover>();
        private readonly Clock _clock;
        private int _threads = Math.Min(Environment.ProcessorCount, MostThreads);
        private Turnstile _turnstile;

        /// <summary>Reads the scene once: every body gets the sum of its effects and the step compiled for that sum.</summary>
        /// <param name="scene">The scene; later changes of it do not change the simulation.</param>
        public Simulation(SceneDescription scene) : this(scene, Omissions.All) { }

        /// <summary>A simulation with a choice of what may be left out, so that its cost can be measured.</summary>
        internal Simulation(SceneDescription scene, Omissions mayLeaveOut)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            MayLeaveOut = mayLeaveOut;
            _clock = new Clock(scene.Steps);
            foreach (BodyDescription body in scene.Bodies)
                Enter(new Body(this) { Name = body.Name, Mover = Moving(body, MayLeaveOut) });
        }

        /// <summary>A simulation with one division of time, and with the given bodies.</summary>
        public Simulation(TimeSteps steps, params BodyDescription[] bodies) : this(new SceneDescription("simulation", string.Empty, steps, bodies)) { }

        /// <summary>The scene at the start.</summary>
        public SceneDescription Scene { get; }

        /// <summary>The bodies, in the order in which they were added; the last takes the index of one that is removed.</summary>
        public IReadOnlyList<Body> Bodies => _bodies;

        /// <summary>The number of steps done.</summary>
        public long StepsDone => _clock.Step;

        /// <summary>
        /// The largest number of threads that step bodies stored together, from 1 to 1024; at first the number of processors.
        /// It does not change the result; on .NET Standard it is always one thread.
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
        /// Adds a body, which starts now. Many bodies added with one description, or with descriptions that differ only in name and start
        /// and have effects of the library only, are stored and stepped together, several at a time and on several threads; each gets the
        /// same bits as alone.
        /// </summary>
        /// <param name="description">The body; later changes of it do not change the motion. Names may repeat.</param>
        public Body Add(BodyDescription description) => Add(Guard.NotNull(description, nameof(description)), description.Start, description.GivenInBody);

        /// <summary>Adds a body, which starts now, in a state of its own.</summary>
        /// <param name="description">The body without its start.</param>
        /// <param name="start">The state at the present time.</param>
        public Body Add(BodyDescription description, in BodyState start) => Add(Guard.NotNull(description, nameof(description)), start, null);

        /// <summary>
        /// Adds a body again that was removed: with its last description, from another start. One that was stored with others is so again,
        /// and nothing is allocated.
        /// </summary>
        /// <param name="removed">A body of this simulation.</param>
        /// <param name="start">The state at the present time.</param>
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

        /// <summary>Removes a body. Its handle still has its name and its plan, and can be added again; everything else throws.</summary>
        public void Remove(Body body)
        {
            Mine(body);
            MayBeChanged();
            Part(body.Mover, body);
            Leave(body);
        }

        /// <summary>
        /// The present states of all bodies, in the order of <see cref="Bodies"/>: those of <see cref="Body.State"/>, several at a time
        /// where many are stored together.
        /// </summary>
        /// <param name="states">Receives the states; elements behind the last body do not change.</param>
        /// <exception cref="StateOverflowException">A body has no finite state; the states before it are written.</exception>
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

        /// <summary>All that a later <see cref="Restore"/> needs to continue from here to the same bits, and with the same bodies.</summary>
        public SavedSimulation Save()
        {
            MayBeChanged();
            return new SavedSimulation(this, _clock, _rest, _bodies.ConvertAll(body => new SavedBody(body)), _crowds.ConvertAll(crowd => new SavedCrowd(crowd)));
        }

        /// <summary>
        /// Returns to a saved time, earlier or later. Bodies removed since then come back with their handles; bodies added since then
        /// are removed.
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

        /// <summary>Refuses a change of the simulation by an effect that acts in it.</summary>
        internal void MayBeChanged()
        {
            _turnstile.Enter("simulation", Scene.Name);
            _turnstile.Leave();
        }

        /// <summary>Plans a body anew from a description.</summary>
        internal void Plan(Body body, BodyDescription description, in BodyState state, Omissions mayLeaveOut)
        {
            bool isSame = description == body.Plan.Asked;
            LoneMover last = Alone(body.Mover, body);
            bool isLoaded = last.Load.Step == StepsDone;
            double ratio = isSame ? last.Plan.MassRatioAt(StepsDone) : 1;
            LoneMover next = Moving(At(isSame ? last.Plan.Asked : description, state, null), isLoaded ? mayLeaveOut & ~last.Load.Needs : mayLeaveOut, ratio);
            last.Arrive(mayCoast: true);
            next.Last = last.Last;
            if (isLoaded)
                next.Add(body, last.Load);

            body.Name = next.Plan.Asked.Name;
            body.Mover = next;
        }

        /// <summary>The mover of a body alone. A body that is stored with others leaves them.</summary>
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
            if (!mover.Remove(body))
                return;

            _crowds.Remove(mover);
            Forget(mover);
        }

        private Body Add(BodyDescription description, in BodyState start, Vector3d? inBody)
        {
            MayBeChanged();
            Body body = new Body(this) { Name = description.Name };
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
            return plan.Rule.Use(plan.Body, new MoverMaker(plan, _clock));
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

        partial void Forget(Mover crowd);

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
