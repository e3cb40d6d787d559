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
        private readonly List<Body> _bodies = new List<Body>();
        private readonly Clock _clock;
        private Turnstile _turnstile;

        /// <summary>Reads the scene once: every body gets the sum of what acts on it and the step made for that sum.</summary>
        /// <param name="scene">The scene; nothing that is changed in it later changes the simulation.</param>
        /// <param name="mayLeaveOut">What may be left out where the motion stays the same.</param>
        public Simulation(Scene scene, Omissions mayLeaveOut = Omissions.All)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            MayLeaveOut = mayLeaveOut;
            _clock = new Clock(scene.Steps);
            foreach (BodyDescription body in scene.Bodies)
                Add(body);
        }

        /// <summary>Bodies that move in steps of one division of time; none at first, if none is named.</summary>
        public Simulation(TimeSteps steps, params BodyDescription[] bodies) : this(new Scene("simulation", string.Empty, steps, bodies)) { }

        /// <summary>What it began with.</summary>
        public Scene Scene { get; }

        /// <summary>The bodies, in the order in which they came; the last takes the place of one that is removed.</summary>
        public IReadOnlyList<Body> Bodies => _bodies;

        /// <summary>How many steps are done.</summary>
        public long StepsDone => _clock.Step;

        /// <summary>Time since the start, s.</summary>
        public double Time => _clock.Steps.StartOf(StepsDone);

        internal Omissions MayLeaveOut { get; }

        /// <summary>Adds a body, which starts now.</summary>
        /// <param name="description">What it is; nothing that is changed in it later changes the body. Names may repeat.</param>
        public Body Add(BodyDescription description)
        {
            Guard.NotNull(description, nameof(description));
            MayBeChanged();
            Body body = new Body(this, Moving(description, MayLeaveOut));
            Enter(body);
            return body;
        }

        /// <summary>Removes a body. Its handle can be asked for its name and its plan, and for nothing else.</summary>
        public void Remove(Body body)
        {
            Mine(body);
            MayBeChanged();
            Leave(body);
        }

        /// <summary>All that a later <see cref="Restore"/> needs to go on from here to the same bits, and with the same bodies.</summary>
        public SavedSimulation Save()
        {
            MayBeChanged();
            return new SavedSimulation(this, _clock, _rest, _bodies.ConvertAll(body => new SavedBody(body)));
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
            BodyDescription now = description.Copy(description.Name, description.Mass);
            now.Start = state;
            Mover last = body.Mover;
            bool isLoaded = last.Load.Step == StepsDone;
            Mover next = Moving(now, isLoaded ? mayLeaveOut & ~last.Load.Needs : mayLeaveOut);
            last.Arrive(mayCoast: true);
            next.Last = last.Last;
            if (isLoaded)
                next.Add(last.Load);

            body.Mover = next;
        }

        private Mover Moving(BodyDescription description, Omissions mayLeaveOut)
        {
            BodyPlan plan = new BodyPlan(description, _clock.Steps, mayLeaveOut, StepsDone);
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
            _haveLeft |= body.IsStepped;
        }

        private void Mine(Body body)
        {
            int index = Guard.NotNull(body, nameof(body)).Index;
            if (index < 0 || index >= _bodies.Count || _bodies[index] != body)
                throw new ArgumentException("body: \"" + body.Name + "\" is not in this simulation", nameof(body));
        }
    }
}
