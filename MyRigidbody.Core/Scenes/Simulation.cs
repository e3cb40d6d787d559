using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A scene in motion.</summary>
    public sealed class Simulation
    {
        private readonly Body[] _bodies;

        /// <summary>Reads the scene once: every body gets the sum of what acts on it and the step made for that sum.</summary>
        public Simulation(Scene scene)
        {
            Scene = Guard.NotNull(scene, nameof(scene));
            _bodies = new Body[scene.Bodies.Count];
            for (int i = 0; i < _bodies.Length; i++)
            {
                BodyDescription description = scene.Bodies[i];
                description.Check();
                _bodies[i] = Catalogue.Find(description.Integrator).Build(description, scene.Steps);
            }
        }

        /// <summary>Bodies that move in steps of one division of time.</summary>
        public Simulation(TimeSteps steps, params BodyDescription[] bodies) : this(new Scene("simulation", string.Empty, steps, bodies)) { }

        /// <summary>What is simulated.</summary>
        public Scene Scene { get; }

        /// <summary>The bodies, in the order of the scene.</summary>
        public IReadOnlyList<Body> Bodies => _bodies;

        /// <summary>How many steps are done.</summary>
        public long StepsDone { get; private set; }

        /// <summary>Time since the start, s.</summary>
        public double Time => Scene.Steps.StartOf(StepsDone);

        /// <summary>One step of all bodies. Allocates nothing.</summary>
        public void Step() => Step(1);

        /// <summary>A number of steps of all bodies; the same bits as that many single ones, and less overhead.</summary>
        public void Step(long count)
        {
            long left = Scene.Steps.Count - StepsDone;
            if (count < 0 || count > left)
                throw Guard.Refused(nameof(count), count, "must be from 0 to the " + left + " steps that the scene has left");

            for (int i = 0; i < _bodies.Length; i++)
                _bodies[i].Step(StepsDone, StepsDone + count);

            StepsDone += count;
        }
    }
}
