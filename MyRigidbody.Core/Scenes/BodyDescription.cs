using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A body of a scene: what it is, how it starts, what acts on it, and by which rule it moves.</summary>
    public sealed class BodyDescription
    {
        // every stretch of time holds its own sum, so memory goes with the square
        private const int MostEffects = 1000;

        // of an angular velocity about a locked axis, that of the rest; as floats hold it, and as doubles do
        private const double RoundedToSingle = 1e-5, Rounded = 1e-12, Denormal = 1e-30;
        private readonly List<Effect> _effects = new List<Effect>();
        private BodyState _start = BodyState.AtRest;
        private Vector3d? _inBody;

        /// <summary>A body at rest at the origin, on which nothing acts.</summary>
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

        /// <summary>The rule by which it moves: one of <see cref="Rules"/>, or your own.</summary>
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
        /// The angular velocity at time zero in body axes, rad/s. Set after <see cref="Start"/>, whose own it replaces: rules that
        /// hold it in body axes then start with these very numbers, and a tiny component beside a large one keeps its digits.
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

        /// <summary>Axes along which it cannot move and about which it cannot turn.</summary>
        public Locks Lock { get; set; }

        /// <summary>Short for no and for all of <see cref="Locks.Move"/>.</summary>
        public bool CanMove
        {
            get => (Lock & Locks.Move) != Locks.Move;
            set => Lock = value ? Lock & ~Locks.Move : Lock | Locks.Move;
        }

        /// <summary>Short for no and for all of <see cref="Locks.Turn"/>.</summary>
        public bool CanTurn
        {
            get => (Lock & Locks.Turn) != Locks.Turn;
            set => Lock = value ? Lock & ~Locks.Turn : Lock | Locks.Turn;
        }

        /// <summary>For the lab's integrators.</summary>
        public LabSettings Lab { get; set; } = new LabSettings();

        /// <summary>For <c>UnityRigidbody</c>.</summary>
        public UnitySettings Unity { get; set; } = new UnitySettings();

        /// <summary>What acts on it. What is not here is not computed.</summary>
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

        /// <summary>Lets the mass grow or fall, for all time or for a part of it (s); it is <see cref="Mass"/> when the body comes into a simulation.</summary>
        public BodyDescription With(MassRate rate, double from = 0, double to = double.PositiveInfinity)
        {
            _effects.Add(new PlainEffect(rate, from, to));
            return this;
        }

        /// <summary>Adds an impulse at the beginning of the first step that starts at a time (s) or after it.</summary>
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

        /// <summary>The same body under another name and with other mass properties; the effects may then differ.</summary>
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

        /// <summary>Takes away the effects for which the condition holds.</summary>
        public BodyDescription Without(System.Predicate<Effect> condition)
        {
            _effects.RemoveAll(condition);
            return this;
        }

        /// <summary>True if they differ in their starts alone.</summary>
        internal bool IsLike(BodyDescription other)
        {
            bool isLike = Name == other.Name && Mass == other.Mass && Rule == other.Rule && Lock == other.Lock
                && Lab.IsLike(other.Lab) && Unity.IsLike(other.Unity) && _effects.Count == other._effects.Count;
            for (int i = 0; isLike && i < _effects.Count; i++)
                isLike = _effects[i] == other._effects[i];

            return isLike;
        }

        internal int IndexOf(Effect effect) => _effects.IndexOf(effect);

        /// <summary>Refuses, by name and value, what only shows when all has been said. A simulation does so before it begins.</summary>
        public void Check()
        {
            CheckAllElse();
            Check(Start);
        }

        /// <summary>The same of all but its start.</summary>
        internal void CheckAllElse()
        {
            Guard.NotNull(Rule, nameof(Rule));
            Guard.NotNull(Lab, nameof(Lab));
            Guard.NotNull(Unity, nameof(Unity));
            if (_effects.Count > MostEffects)
                throw Guard.Refused("effects", _effects.Count, "must be at most " + MostEffects);
        }

        /// <summary>Refuses a state that such a body cannot have.</summary>
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
