using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A simulation as it was at one time.</summary>
    public sealed class SavedSimulation
    {
        internal SavedSimulation(Simulation owner, Clock clock, double rest, List<SavedBody> bodies, List<SavedCrowd> crowds)
        {
            Owner = owner;
            StepsDone = clock.Step;
            LastLength = clock.LastLength;
            Division = clock.Steps.Division;
            Rest = rest;
            Bodies = bodies;
            Crowds = crowds;
        }

        /// <summary>How many steps had been done.</summary>
        public long StepsDone { get; }

        internal Simulation Owner { get; }

        internal double LastLength { get; }

        internal TimeSteps.Grid Division { get; }

        internal double Rest { get; }

        internal List<SavedBody> Bodies { get; }

        internal List<SavedCrowd> Crowds { get; }
    }

    /// <summary>A body as it was, and its mover.</summary>
    internal readonly struct SavedBody
    {
        public readonly Body Body;
        private readonly string _name;
        private readonly Mover _mover;
        private readonly object _moment;

        public SavedBody(Body body)
        {
            Body = body;
            _name = body.Name;
            _mover = body.Mover;
            _moment = _mover.HasMany ? null : _mover.Save();
        }

        public void Restore()
        {
            Body.Name = _name;
            Body.Mover = _mover;
            if (!_mover.HasMany)
                _mover.Restore(_moment);
        }
    }

    /// <summary>A batch of bodies as they were, with their places.</summary>
    internal readonly struct SavedCrowd
    {
        public readonly Mover Mover;
        private readonly object _moment;

        public SavedCrowd(Mover mover)
        {
            Mover = mover;
            _moment = mover.Save();
        }

        public void Restore() => Mover.Restore(_moment);
    }
}
