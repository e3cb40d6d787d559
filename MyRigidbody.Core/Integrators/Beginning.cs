namespace RigidBodyDynamics
{
    /// <summary>What a rule takes over: a body and the state it goes on from.</summary>
    public readonly struct Beginning
    {
        private readonly BodyDescription _body;
        private readonly Vector3d? _inBody;

        /// <summary>A body at its start. A simulation makes this itself; whoever drives a rule by hand checks the body before.</summary>
        internal Beginning(BodyDescription body)
        {
            _body = Guard.NotNull(body, nameof(body));
            _inBody = body.GivenInBody;
            Raw = body.Start;
        }

        /// <summary>A body that is put into a state while it runs.</summary>
        internal Beginning(BodyDescription body, in BodyState state)
        {
            _body = body;
            _inBody = null;
            Raw = state;
        }

        /// <summary>The state, its orientation scaled to length 1.</summary>
        public BodyState State => new BodyState(Raw.Position, Raw.Orientation.Normalized, Raw.Velocity, Raw.AngularVelocity);

        /// <summary>The state as it was given, for a rule that scales the orientation in its own arithmetic.</summary>
        public BodyState Raw { get; }

        /// <summary>Mass and inertia.</summary>
        public MassProperties Mass => _body.Mass;

        /// <summary>False for a body that does not translate.</summary>
        public bool CanMove => _body.CanMove;

        /// <summary>False for a body that does not rotate.</summary>
        public bool CanTurn => _body.CanTurn;

        /// <summary>For the one rule that holds a body itself (<see cref="Rule.HoldsAxes"/>).</summary>
        internal Locks Lock => _body.Lock;

        /// <summary>For the lab's rules.</summary>
        public LabSettings Lab => _body.Lab;

        /// <summary>For <c>UnityRigidbody</c>.</summary>
        public UnitySettings Unity => _body.Unity;

        /// <summary>The orientation with the digits that <see cref="State"/> has rounded away.</summary>
        internal Quaterniondd Orientation => Quaterniondd.Unit(Raw.Orientation);

        /// <summary>The angular velocity in body axes, rad/s; as it was given, where it was given there.</summary>
        internal Vector3dd AngularVelocityInBody => _inBody ?? Orientation.Conjugate.Rotate(Raw.AngularVelocity);
    }
}
