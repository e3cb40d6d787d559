namespace RigidBodyDynamics
{
    /// <summary>What an integrator starts from: a body and its state.</summary>
    public readonly struct Beginning
    {
        private readonly BodyDescription _body;
        private readonly Vector3d? _inBody;

        /// <summary>A body at its start. A simulation creates this itself; a program that calls an integrator directly checks the body first.</summary>
        internal Beginning(BodyDescription body)
        {
            _body = Guard.NotNull(body, nameof(body));
            _inBody = body.GivenInBody;
            Raw = body.Start;
        }

        /// <summary>A body whose state is set while it runs.</summary>
        internal Beginning(BodyDescription body, in BodyState state)
        {
            _body = body;
            _inBody = null;
            Raw = state;
        }

        /// <summary>The state, its orientation scaled to length 1.</summary>
        public BodyState State => new BodyState(Raw.Position, Raw.Orientation.Normalized, Raw.Velocity, Raw.AngularVelocity);

        /// <summary>The state as given, for an integrator that scales the orientation in its own arithmetic.</summary>
        public BodyState Raw { get; }

        /// <summary>Mass and inertia.</summary>
        public MassProperties Mass => _body.Mass;

        /// <summary>False for a body that does not translate.</summary>
        public bool CanMove => _body.CanMove;

        /// <summary>False for a body that does not rotate.</summary>
        public bool CanTurn => _body.CanTurn;

        /// <summary>For the one integrator that implements locks itself (<see cref="Rule.HoldsAxes"/>).</summary>
        internal Locks Lock => _body.Lock;

        /// <summary>For the lab's integrators.</summary>
        public LabSettings Lab => _body.Lab;

        /// <summary>For <c>UnityRigidbody</c>.</summary>
        public UnitySettings Unity => _body.Unity;

        /// <summary>The orientation, scaled to length 1 in twice the digits.</summary>
        internal Quaterniondd Orientation => Quaterniondd.Unit(Raw.Orientation);

        /// <summary>The angular velocity in body axes, rad/s; the numbers given in body axes, where they were.</summary>
        internal Vector3dd AngularVelocityInBody => _inBody ?? Orientation.Conjugate.Rotate(Raw.AngularVelocity);
    }
}
