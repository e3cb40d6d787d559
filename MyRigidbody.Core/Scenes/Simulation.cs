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

        private readonly List<Body> _stepped;
        private readonly WakeQueue _dormant;
        private Turnstile _turnstile;

        /// <summary>Reads the scene once: every body gets the sum of what acts on it and the step made for that sum.</summary>
        /// <param name="scene">The scene; nothing that is changed in it later changes the simulation.</param>
        /// <param name="mayLeaveOut">What may be left out where the motion stays the same.</param>
        public Simulation(Scene scene, Omissions mayLeaveOut = Omissions.All)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            int count = scene.Bodies.Count;
            _bodies = new Body[count];
            _stepped = new List<Body>(count);
            _dormant = new WakeQueue(count);
            for (int i = 0; i < count; i++)
            {
                BodyPlan plan = new BodyPlan(scene.Bodies[i], scene.Steps, mayLeaveOut);
                _bodies[i] = plan.Rule.Build(plan, _clock);
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
        /// <exception cref="StateOverflowException">
        /// The step of a body did not lead to a finite state. All bodies then stand before it. A body that coasts is not looked
        /// at: it says so when its state is asked for, or when an effect begins to act on it.
        /// </exception>
        /// <exception cref="InvalidOperationException">An effect stepped the simulation that it acts in, or another thread did.</exception>
        public void Step(long count)
        {
            long left = Scene.Steps.Count - StepsDone;
            if (count < 0 || count > left)
                throw Guard.Refused(nameof(count), count, "must be from 0 to the " + left + " steps that the scene has left");

            _turnstile.Enter("simulation", Scene.Name);
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
            while (_dormant.Next < end)
                _stepped.Add(_dormant.Take());

            Exception failure = null;
            for (int i = 0; i < _stepped.Count; i++)
            {
                long reached = _stepped[i].Advance(end, ref failure);
                if (reached == end)
                    continue;

                // where one cannot go on, all go back and come as far as that one came
                end = reached;
                for (; i >= 0; i--)
                    _stepped[i].GoBack();
            }

            _clock.Step = end;
            LayDown();
            if (failure != null)
                ExceptionDispatchInfo.Capture(failure).Throw();
        }

        /// <summary>All that a later <see cref="Restore"/> needs to go on from here to the same bits.</summary>
        public SavedSimulation Save()
        {
            _turnstile.Enter("simulation", Scene.Name);
            try
            {
                return new SavedSimulation(this, StepsDone, Array.ConvertAll(_bodies, body => body.Save()));
            }
            finally
            {
                _turnstile.Leave();
            }
        }

        /// <summary>Goes back, or on, to where the simulation was when it was saved.</summary>
        public void Restore(SavedSimulation saved)
        {
            if (Guard.NotNull(saved, nameof(saved)).Owner != this)
                throw new ArgumentException("saved: must come from the same simulation", nameof(saved));

            _turnstile.Enter("simulation", Scene.Name);
            for (int i = 0; i < _bodies.Length; i++)
                _bodies[i].Restore(saved.Bodies[i]);

            _clock.Step = saved.StepsDone;
            Sort();
            _turnstile.Leave();
        }

        private void Sort()
        {
            _stepped.Clear();
            _dormant.Clear();
            _stepped.AddRange(_bodies);
            LayDown();
        }

        private void LayDown()
        {
            int kept = 0;
            for (int i = 0; i < _stepped.Count; i++)
            {
                Body body = _stepped[i];
                if (!body.IsDormant)
                    _stepped[kept++] = body;
                else if (body.WakesAt < Scene.Steps.Count)
                    _dormant.Add(body.WakesAt, body);
            }

            if (kept < _stepped.Count)
                _stepped.RemoveRange(kept, _stepped.Count - kept);
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
