using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A simulation as it was at one time.</summary>
    public sealed class SavedSimulation
    {
        internal SavedSimulation(Simulation owner, Clock clock, double rest, List<SavedBody> bodies)
        {
            Owner = owner;
            StepsDone = clock.Step;
            LastLength = clock.LastLength;
            Division = clock.Steps.Division;
            Rest = rest;
            Bodies = bodies;
        }

        /// <summary>How many steps had been done.</summary>
        public long StepsDone { get; }

        internal Simulation Owner { get; }

        internal double LastLength { get; }

        internal TimeSteps.Grid Division { get; }

        internal double Rest { get; }

        internal List<SavedBody> Bodies { get; }
    }

    /// <summary>A body as it was, and what moved it.</summary>
    internal readonly struct SavedBody
    {
        public readonly Body Body;
        private readonly Mover _mover;
        private readonly object _moment;

        public SavedBody(Body body)
        {
            Body = body;
            _mover = body.Mover;
            _moment = _mover.Save();
        }

        public void Restore()
        {
            Body.Mover = _mover;
            _mover.Restore(_moment);
        }
    }
}
