using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A body in motion: the handle that <see cref="Simulation.Add(BodyDescription)"/> returns. After removal the handle says so, and is
    /// never reused for another body.
    /// </summary>
    public sealed class Body
    {
        private Mover _mover;

        internal Body(Simulation simulation) => Simulation = simulation;

        /// <summary>Its name.</summary>
        public string Name { get; internal set; }

        /// <summary>Its mass and inertia at the present step.</summary>
        public MassProperties Mass => Plan.ChangesMass ? Plan.Asked.Mass.Times(Plan.MassRatioAt(Simulation.StepsDone)) : Plan.Asked.Mass;

        /// <summary>The parts of its motion since it was last planned, and what was left out.</summary>
        internal BodyPlan Plan => Mover.Plan;

        /// <summary>The integrator by which it moves.</summary>
        public Rule Rule => Plan.Rule;

        /// <summary>An object of the program's choice.</summary>
        public object Tag { get; set; }

        /// <summary>True once it has been removed.</summary>
        public bool IsRemoved => Index < 0;

        /// <summary>
        /// Its present state. A body that coasts is computed when this is read, so two threads must not read one body at the same
        /// time. A state that is set is valid from now on; <see cref="Between"/> has no path to it.
        /// </summary>
        /// <exception cref="InvalidOperationException">The body has been removed, or an effect sets a state.</exception>
        public BodyState State
        {
            get => Here().StateOf(this);
            set
            {
                Mover mover = Changing();
                Plan.Asked.Check(value);
                Omissions needs = BodyPlan.Needs(value);
                // first, because a body that has diverged has no state to continue from
                mover.Set(this, value);
                if ((needs & mover.Plan.LeftOut) != 0)
                {
                    Simulation.Plan(this, Plan.Asked, value, Plan.MayLeaveOut & ~needs);
                    Mover.Set(this, value);
                }

                Simulation.Sort(this);
            }
        }

        /// <summary>True while its integrator has put it to sleep.</summary>
        public bool IsAsleep => Here().IsAsleep(this);

        /// <summary>True while nothing is computed until its state is read: it sleeps, or coasts by a closed form.</summary>
        public bool IsDormant => Here().IsDormant(this);

        /// <summary>Kinetic energy of the translation and the rotation, J.</summary>
        public double KineticEnergy => Conserved.KineticEnergy(State, Mass);

        /// <summary>Angular momentum about the centre of mass, kg m²/s, world axes.</summary>
        public Vector3d AngularMomentum => Conserved.AngularMomentum(State, Mass);

        internal Simulation Simulation { get; }

        /// <summary>Moves it until it is planned anew.</summary>
        internal Mover Mover
        {
            get => _mover;
            set
            {
                _mover = value;
                if (value is LoneMover alone)
                    alone.Owner = this;
            }
        }

        /// <summary>Its place in <see cref="Simulation.Bodies"/>; −1 once it has been removed.</summary>
        internal int Index { get; set; } = -1;

        /// <summary>Its place among the dormant bodies that an effect will wake; −1 if it is not among them.</summary>
        internal int PlaceInQueue { get; set; } = -1;

        /// <summary>True while it is among the bodies that are stepped.</summary>
        internal bool IsStepped { get; set; }

        /// <summary>Its place in its batch.</summary>
        internal int Place { get; set; }

        /// <summary>
        /// The state during the last step: at its beginning for 0, at its end for 1. A body that coasted is evaluated on its exact
        /// motion; any other is interpolated between its poses (orientation by slerp, centre of mass by Hermite's cubic). Before the
        /// first call the last step is not stored: a body that was changed after that step then has its last state.
        /// </summary>
        /// <param name="alpha">0 to 1, for instance <see cref="Simulation.Alpha"/>.</param>
        /// <remarks>The first call moves a body that is stored with others to storage of its own, and allocates.</remarks>
        public BodyState Between(double alpha)
        {
            if (!(alpha >= 0 && alpha <= 1))
                throw Guard.Refused(nameof(alpha), alpha, "must be from 0 to 1");

            return (Here() as LoneMover ?? Simulation.Alone(Changing(), this)).Between(alpha);
        }

        /// <summary>
        /// Applies a force (N) at the centre of mass during the next step. If that step leads to no finite state, the load on the
        /// body is dropped.
        /// </summary>
        public void ApplyForce(Vector3d force, bool inBody = false) =>
            AddLoad(Load.Of(Guard.Finite(force, nameof(force)), Vector3d.Zero, inBody));

        /// <summary>
        /// Applies a force (N) at a point (m) during the next step. In world axes force and torque stay constant for the whole step;
        /// in body axes both rotate with the body.
        /// </summary>
        public void ApplyForce(Vector3d force, Vector3d point, bool inBody = false) =>
            AddLoad(Load.Of(Guard.Finite(force, nameof(force)), Arm(point, inBody), inBody));

        /// <summary>Applies a torque (N m) during the next step.</summary>
        public void ApplyTorque(Vector3d torque, bool inBody = false) =>
            AddLoad(new Load { Wrench = Turn(Guard.Finite(torque, nameof(torque)), inBody) });

        /// <summary>Applies an impulse (N s) at the centre of mass, now.</summary>
        public void ApplyImpulse(Vector3d impulse, bool inBody = false) =>
            Push(Load.Of(Guard.Finite(impulse, nameof(impulse)), Vector3d.Zero, inBody));

        /// <summary>Applies an impulse (N s) at a point (m), now.</summary>
        public void ApplyImpulse(Vector3d impulse, Vector3d point, bool inBody = false) =>
            Push(Load.Of(Guard.Finite(impulse, nameof(impulse)), Arm(point, inBody), inBody));

        /// <summary>Applies an angular impulse (N m s), now.</summary>
        public void ApplyAngularImpulse(Vector3d impulse, bool inBody = false) =>
            Push(new Load { Wrench = Turn(Guard.Finite(impulse, nameof(impulse)), inBody) });

        /// <summary>
        /// Replaces the body by another at the same pose: other mass, integrator or effects. Its start is not used; times of effects
        /// are those of the simulation, which continues.
        /// </summary>
        /// <param name="description">The description from now on.</param>
        /// <param name="keeping">What is conserved where mass or inertia change.</param>
        public void Change(BodyDescription description, Keeping keeping = Keeping.Velocity)
        {
            Guard.NotNull(description, nameof(description));
            Mover mover = Changing();
            BodyState state = description.Lock.Applied(MassChange.Of(mover.StateOf(this), Mass, description.Mass, keeping), description.Mass);
            Simulation.Plan(this, description, state, Simulation.MayLeaveOut);
            Simulation.Sort(this);
        }

        /// <summary>Its name, and whether it is removed.</summary>
        public override string ToString() => "body \"" + Name + "\"" + (IsRemoved ? " (removed)" : string.Empty);

        private void Push(in Load load)
        {
            Mover mover = Ready(load);
            Wrench impulse = load.BodyForce.IsZero ? load.Wrench : load.At(mover.StateOf(this).Orientation);
            mover.Push(this, Plan.ChangesMass ? impulse.Times(1 / Plan.MassRatioAt(Simulation.StepsDone)) : impulse);
            Simulation.Sort(this);
        }

        private void AddLoad(in Load load)
        {
            Ready(load).Add(this, load);
            Simulation.Sort(this);
        }

        /// <summary>The mover of a body from which nothing is left out that a load needs.</summary>
        private Mover Ready(in Load load)
        {
            Mover mover = Changing();
            if ((load.Needs & mover.Plan.LeftOut) != 0)
                Simulation.Plan(this, Plan.Asked, mover.StateOf(this), Plan.MayLeaveOut & ~load.Needs);

            return Mover;
        }

        private Vector3d Arm(Vector3d point, bool inBody)
        {
            Guard.Finite(point, nameof(point));
            if (inBody)
                return point - Mass.CenterOfMass;

            BodyState state = State;
            return point - state.Position - state.Orientation.Rotate(Mass.CenterOfMass);
        }

        private static Wrench Turn(Vector3d torque, bool inBody) =>
            inBody ? new Wrench { BodyTorque = torque } : new Wrench { Torque = torque };

        private Mover Changing()
        {
            Here();
            Simulation.MayBeChanged();
            return Mover;
        }

        private Mover Here() => !IsRemoved ? Mover : throw new InvalidOperationException(this + ": is not in the simulation any more");
    }
}
