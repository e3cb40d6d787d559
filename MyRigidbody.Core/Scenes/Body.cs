namespace RigidBodyDynamics
{
    /// <summary>A body in motion.</summary>
    public abstract class Body
    {
        internal Body(BodyPlan plan)
        {
            Plan = plan;
            Name = plan.Body.Name;
            Mass = plan.Body.Mass;
        }

        /// <summary>Its name in the scene.</summary>
        public string Name { get; }

        /// <summary>Mass and inertia.</summary>
        public MassProperties Mass { get; }

        /// <summary>What its motion consists of, and what was left out.</summary>
        public BodyPlan Plan { get; }

        /// <summary>The rule by which it moves.</summary>
        public Rule Rule => Plan.Rule;

        /// <summary>
        /// Where it is and how it moves now. A body that coasts is computed when this is asked, so two threads must not
        /// ask one body at the same time.
        /// </summary>
        public abstract BodyState State { get; }

        /// <summary>True while it has been put to sleep.</summary>
        public abstract bool IsAsleep { get; }

        /// <summary>True while nothing is computed for it until somebody looks: it sleeps, or coasts along a closed form.</summary>
        public abstract bool IsDormant { get; }

        /// <summary>Kinetic energy of the translation and the rotation, J.</summary>
        public double KineticEnergy => Conserved.KineticEnergy(State, Mass);

        /// <summary>Angular momentum about the centre of mass, kg m²/s, world axes.</summary>
        public Vector3d AngularMomentum => Conserved.AngularMomentum(State, Mass);

        /// <summary>The step by which it has to be stepped again, while it is dormant.</summary>
        internal abstract long WakesAt { get; }

        /// <summary>Goes on to the end of a step, or as far as its effects let it; what stopped it comes with the answer.</summary>
        internal abstract long Advance(long end, ref System.Exception failure);

        /// <summary>Back to where the last <see cref="Advance"/> began.</summary>
        internal abstract void GoBack();

        internal abstract object Save();

        internal abstract void Restore(object saved);
    }
}
