using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;

namespace RigidBodyDynamics
{
    /// <summary>A scene in motion.</summary>
    public sealed class Simulation
    {
        private readonly Body[] _bodies;
        private readonly Clock _clock = new Clock();

        // those that are stepped: bodies with pushes, which may have to go back, and the others
        private readonly List<Body> _pushed, _unpushed;
        private readonly WakeQueue _dormant;

        /// <summary>Reads the scene once: every body gets the sum of what acts on it and the step made for that sum.</summary>
        /// <param name="scene">The scene; nothing that is changed in it later changes the simulation.</param>
        /// <param name="mayLeaveOut">What may be left out where the motion stays the same.</param>
        public Simulation(Scene scene, Omissions mayLeaveOut = Omissions.All)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            int count = scene.Bodies.Count;
            _bodies = new Body[count];
            _pushed = new List<Body>(count);
            _unpushed = new List<Body>(count);
            _dormant = new WakeQueue(count);
            for (int i = 0; i < count; i++)
            {
                BodyPlan plan = new BodyPlan(scene.Bodies[i], scene.Steps, mayLeaveOut);
                _bodies[i] = plan.Row.Build(plan, _clock);
            }

            Sort();
        }

        /// <summary>Bodies that move in steps of one division of time.</summary>
        public Simulation(TimeSteps steps, params BodyDescription[] bodies) : this(new Scene("simulation", string.Empty, steps, bodies)) { }

        /// <summary>What is simulated.</summary>
        public Scene Scene { get; }

        /// <summary>The bodies, in the order of the scene.</summary>
        public IReadOnlyList<Body> Bodies => _bodies;

        /// <summary>How many steps are done.</summary>
        public long StepsDone => _clock.Step;

        /// <summary>Time since the start, s.</summary>
        public double Time => Scene.Steps.StartOf(StepsDone);

        /// <summary>One step of all bodies. Allocates nothing.</summary>
        public void Step() => Step(1);

        /// <summary>A number of steps of all bodies; the same bits as that many single ones, and less overhead.</summary>
        /// <exception cref="BrokenEffectException">
        /// An effect gave a force that is not finite, or threw an exception. All bodies then stand before the step in which it did.
        /// </exception>
        public void Step(long count)
        {
            long left = Scene.Steps.Count - StepsDone;
            if (count < 0 || count > left)
                throw Guard.Refused(nameof(count), count, "must be from 0 to the " + left + " steps that the scene has left");

            long end = StepsDone + count;
            while (_dormant.Next < end)
                Wake(_dormant.Take());

            Exception failure = null;
            for (int i = 0; i < _pushed.Count; i++)
            {
                long reached = _pushed[i].Advance(end, ref failure);
                if (reached == end)
                    continue;

                // where one cannot go on, all go back and come as far as that one came
                end = reached;
                for (; i >= 0; i--)
                    _pushed[i].GoBack();
            }

            for (int i = 0; i < _unpushed.Count; i++)
                _unpushed[i].Advance(end, ref failure);

            _clock.Step = end;
            LayDown(_pushed);
            LayDown(_unpushed);
            if (failure != null)
                ExceptionDispatchInfo.Capture(failure).Throw();
        }

        /// <summary>All that a later <see cref="Restore"/> needs to go on from here to the same bits.</summary>
        public SavedSimulation Save() => new SavedSimulation(this, StepsDone, Array.ConvertAll(_bodies, body => body.Save()));

        /// <summary>Goes back, or on, to where the simulation was when it was saved.</summary>
        public void Restore(SavedSimulation saved)
        {
            if (Guard.NotNull(saved, nameof(saved)).Owner != this)
                throw new ArgumentException("saved: must come from the same simulation", nameof(saved));

            for (int i = 0; i < _bodies.Length; i++)
                _bodies[i].Restore(saved.Bodies[i]);

            _clock.Step = saved.StepsDone;
            Sort();
        }

        private void Sort()
        {
            _pushed.Clear();
            _unpushed.Clear();
            _dormant.Clear();
            foreach (Body body in _bodies)
                Wake(body);

            LayDown(_pushed);
            LayDown(_unpushed);
        }

        private void Wake(Body body) => (body.Plan.IsPushed ? _pushed : _unpushed).Add(body);

        private void LayDown(List<Body> stepped)
        {
            int kept = 0;
            for (int i = 0; i < stepped.Count; i++)
            {
                Body body = stepped[i];
                if (!body.IsDormant)
                    stepped[kept++] = body;
                else if (body.WakesAt < Scene.Steps.Count)
                    _dormant.Add(body.WakesAt, body);
            }

            if (kept < stepped.Count)
                stepped.RemoveRange(kept, stepped.Count - kept);
        }
    }

    /// <summary>A simulation as it was at one time.</summary>
    public sealed class SavedSimulation
    {
        internal SavedSimulation(Simulation owner, long stepsDone, object[] bodies)
        {
            Owner = owner;
            StepsDone = stepsDone;
            Bodies = bodies;
        }

        /// <summary>How many steps had been done.</summary>
        public long StepsDone { get; }

        internal Simulation Owner { get; }

        internal object[] Bodies { get; }
    }
}
