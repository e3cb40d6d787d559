using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A body of a scene: its mass properties, its start, the effects on it, and its integrator.</summary>
    public sealed class BodyDescription
    {
        // every stretch of time holds its own sum, so memory grows with the square
        private const int MostEffects = 1000;

        // limits for an angular velocity about a locked axis, relative to the whole: the rounding of floats, and that of doubles
        private const double RoundedToSingle = 1e-5, Rounded = 1e-12, Denormal = 1e-30;
        private readonly List<Effect> _effects = new List<Effect>();
        private BodyState _start = BodyState.AtRest;
        private Vector3d? _inBody;

        /// <summary>A body at rest at the origin, without effects.</summary>
        /// <param name="name">Unique in its scene.</param>
        /// <param name="mass">Mass and inertia, for instance of <see cref="Solids"/> or <see cref="PointMasses"/>.</param>
        public BodyDescription(string name, MassProperties mass)
        {
            Name = !string.IsNullOrEmpty(name) ? name : throw Guard.Refused(nameof(name), name, "must not be empty");
            Mass = Guard.NotNull(mass, nameof(mass));
        }

        /// <summary>Its name.</summary>
        public string Name { get; }

        /// <summary>Mass and inertia.</summary>
        public MassProperties Mass { get; }

        /// <summary>The integrator by which it moves: one of <see cref="Rules"/>, or your own.</summary>
        public Rule Rule { get; set; } = Rules.Default;

        /// <summary>The state at time zero.</summary>
        public BodyState Start
        {
            get => _start;
            set
            {
                _start = value;
                _inBody = null;
            }
        }

        /// <summary>
        /// The angular velocity at time zero in body axes, rad/s. Set it after <see cref="Start"/>, whose value it replaces: integrators
        /// that work in body axes then start with exactly these numbers, and a tiny component beside a large one keeps its digits.
        /// </summary>
        public Vector3d AngularVelocityInBody
        {
            get => new Beginning(this).AngularVelocityInBody.Rounded;
            set
            {
                _start.AngularVelocity = Quaterniondd.Unit(_start.Orientation).Rotate(value).Rounded;
                _inBody = value;
            }
        }

        internal Vector3d? GivenInBody => _inBody;

        /// <summary>Axes along which it cannot move and about which it cannot rotate.</summary>
        public Locks Lock { get; set; }

        /// <summary>False if all of <see cref="Locks.Move"/> is locked; setting it locks all or nothing of it.</summary>
        public bool CanMove
        {
            get => (Lock & Locks.Move) != Locks.Move;
            set => Lock = value ? Lock & ~Locks.Move : Lock | Locks.Move;
        }

        /// <summary>False if all of <see cref="Locks.Turn"/> is locked; setting it locks all or nothing of it.</summary>
        public bool CanTurn
        {
            get => (Lock & Locks.Turn) != Locks.Turn;
            set => Lock = value ? Lock & ~Locks.Turn : Lock | Locks.Turn;
        }

        /// <summary>For the lab's integrators.</summary>
        public LabSettings Lab { get; set; } = new LabSettings();

        /// <summary>For <c>UnityRigidbody</c>.</summary>
        public UnitySettings Unity { get; set; } = new UnitySettings();

        /// <summary>The effects on it. An effect that is not listed is not computed.</summary>
        public IReadOnlyList<Effect> Effects => _effects;

        /// <summary>Adds a push, for all time or for a part of it (s).</summary>
        public BodyDescription With<TPush>(TPush push, double from = 0, double to = double.PositiveInfinity)
            where TPush : struct, IPush
        {
            _effects.Add(new PushEffect<TPush>(push, from, to));
            return this;
        }

        /// <summary>Adds gravity or a damping, for all time or for a part of it (s).</summary>
        public BodyDescription With(ICoast coast, double from = 0, double to = double.PositiveInfinity)
        {
            _effects.Add(new PlainEffect(Guard.NotNull(coast, nameof(coast)), from, to));
            return this;
        }

        /// <summary>Lets the mass grow or fall, for all time or for a part of it (s); <see cref="Mass"/> is its value when the body is added to a simulation.</summary>
        public BodyDescription With(MassRate rate, double from = 0, double to = double.PositiveInfinity)
        {
            _effects.Add(new PlainEffect(rate, from, to));
            return this;
        }

        /// <summary>Adds an impulse at the beginning of the first step that starts at or after a time (s).</summary>
        public BodyDescription With(Impulse impulse, double time)
        {
            _effects.Add(new ImpulseEffect(impulse, time));
            return this;
        }

        /// <summary>Adds an effect of another body.</summary>
        public BodyDescription With(Effect effect)
        {
            _effects.Add(Guard.NotNull(effect, nameof(effect)));
            return this;
        }

        /// <summary>A copy with another name and other mass properties; its effects can be changed separately.</summary>
        public BodyDescription Copy(string name, MassProperties mass)
        {
            BodyDescription copy = new BodyDescription(name, mass)
            {
                Rule = Rule,
                Start = Start,
                Lock = Lock,
                Lab = Lab?.Copy(),
                Unity = Unity?.Copy(),
            };
            copy._inBody = _inBody;
            copy._effects.AddRange(_effects);
            return copy;
        }

        /// <summary>Removes the effects for which the condition holds.</summary>
        public BodyDescription Without(System.Predicate<Effect> condition)
        {
            _effects.RemoveAll(condition);
            return this;
        }

        internal int IndexOf(Effect effect) => _effects.IndexOf(effect);

        /// <summary>Refuses, by name and value, combinations that no single setter can refuse. A simulation calls it before it begins.</summary>
        public void Check()
        {
            CheckAllElse();
            Check(Start);
        }

        /// <summary>The same without the start.</summary>
        internal void CheckAllElse()
        {
            Guard.NotNull(Rule, nameof(Rule));
            Guard.NotNull(Lab, nameof(Lab));
            Guard.NotNull(Unity, nameof(Unity));
            if (_effects.Count > MostEffects)
                throw Guard.Refused("effects", _effects.Count, "must be at most " + MostEffects);
        }

        /// <summary>Refuses a state that this body cannot have.</summary>
        internal void Check(in BodyState state)
        {
            Guard.Finite(state.Position, "position");
            Guard.Turn(state.Orientation, "orientation");
            Guard.Finite(state.Velocity, "velocity");
            Guard.Finite(state.AngularVelocity, "angularVelocity");
            BodyState unturned = new BodyState(Vector3d.Zero, state.Orientation.Normalized, state.Velocity, Vector3d.Zero);
            if (!Guard.IsFinite(Conserved.KineticEnergy(unturned, Mass)))
                throw Guard.Refused("velocity", state.Velocity, "must leave a finite kinetic energy");

            unturned.Velocity = Vector3d.Zero;
            unturned.AngularVelocity = state.AngularVelocity;
            if (!Guard.IsFinite(Conserved.KineticEnergy(unturned, Mass)))
                throw Guard.Refused("angularVelocity", state.AngularVelocity, "must leave a finite kinetic energy");

            BodyState left = Lock.Applied(state, Mass);
            if (left.Velocity != state.Velocity)
                throw Guard.Refused("velocity", state.Velocity, "must be zero along the locked " + Lock.MoveNames());

            // in world axes it has been rounded
            double most = Rule.HoldsAxes ? RoundedToSingle * state.AngularVelocity.Length + Denormal : Rounded * state.AngularVelocity.Length;
            if ((left.AngularVelocity - state.AngularVelocity).Length > most)
                throw Guard.Refused("angularVelocity", state.AngularVelocity, "must be zero about the locked " + Lock.TurnNames());
        }
    }
}
