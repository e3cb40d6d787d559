using System;

namespace RigidBodyDynamics
{
    /// <summary>A body in motion.</summary>
    public abstract class Body
    {
        internal Body(BodyDescription description)
        {
            Name = description.Name;
            Mass = description.Mass;
            Integrator = description.Integrator;
        }

        /// <summary>Its name in the scene.</summary>
        public string Name { get; }

        /// <summary>Mass and inertia.</summary>
        public MassProperties Mass { get; }

        /// <summary>Name of the rule by which it moves.</summary>
        public string Integrator { get; }

        /// <summary>Where it is and how it moves now.</summary>
        public abstract BodyState State { get; }

        /// <summary>True while it has been put to sleep.</summary>
        public abstract bool IsAsleep { get; }

        /// <summary>Kinetic energy of the translation and the rotation, J.</summary>
        public double KineticEnergy => Conserved.KineticEnergy(State, Mass);

        /// <summary>Angular momentum about the centre of mass, kg m²/s, world axes.</summary>
        public Vector3d AngularMomentum => Conserved.AngularMomentum(State, Mass);

        internal abstract void Step(long first, long end);
    }

    /// <summary>A body that moves by one rule, with a stretch of time for every sum of effects that acts on it.</summary>
    internal sealed class Body<TIntegrator> : Body where TIntegrator : struct, IIntegrator
    {
        private readonly Stretch<TIntegrator>[] _stretches;
        private readonly TimeSteps _steps;
        private TIntegrator _integrator;
        private int _current = -1;

        public Body(BodyDescription description, TimeSteps steps) : base(description)
        {
            _steps = steps;
            _stretches = StretchBuilder<TIntegrator>.Divide(description, steps);
            _integrator.Start(description);
        }

        public override BodyState State => _integrator.State;

        public override bool IsAsleep => _integrator.IsAsleep;

        internal override void Step(long first, long end)
        {
            while (first < end)
            {
                if (_current < 0 || first == _stretches[_current].End)
                    _current++;

                Stretch<TIntegrator> stretch = _stretches[_current];
                long stop = Math.Min(end, stretch.End);
                stretch.Run(ref _integrator, _steps, first, stop);
                first = stop;
            }
        }
    }
}
