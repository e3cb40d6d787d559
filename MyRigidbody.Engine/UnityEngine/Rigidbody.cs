using RigidBodyDynamics;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>Unity's own body, moved here by the library's UnityRigidbody.</summary>
    public sealed class Rigidbody : Component
    {
        private readonly PhysicsBody _body = new PhysicsBody();
        private float _mass = 1, _drag, _angularDrag = 0.05f, _maxAngularVelocity = 7, _sleepThreshold = 0.005f;
        private RigidbodyConstraints _constraints;
        private Vector3? _inertiaTensor;
        private Quaternion _inertiaTensorRotation = Quaternion.identity;
        private Vector3? _centerOfMass;

        public float mass { get => _mass; set => Set(ref _mass, value); }

        public bool useGravity { get; set; } = true;

        /// <summary>How it is drawn between two steps; here always in its last pose.</summary>
        public RigidbodyInterpolation interpolation { get; set; }

        /// <summary>True: the engine does not move it.</summary>
        public bool isKinematic { get; set; }

        public float maxAngularVelocity { get => _maxAngularVelocity; set => Set(ref _maxAngularVelocity, value); }

        public float sleepThreshold { get => _sleepThreshold; set => Set(ref _sleepThreshold, value); }

        public RigidbodyConstraints constraints { get => _constraints; set => Set(ref _constraints, value); }

        public bool freezeRotation
        {
            get => (_constraints & RigidbodyConstraints.FreezeRotation) == RigidbodyConstraints.FreezeRotation;
            set => constraints = value ? _constraints | RigidbodyConstraints.FreezeRotation : _constraints & ~RigidbodyConstraints.FreezeRotation;
        }

        /// <summary>
        /// Moments about the principal axes: those of the collider until a script sets others, and 0 where the rotation is frozen.
        /// </summary>
        public Vector3 inertiaTensor
        {
            get
            {
                Vector3 free = _inertiaTensor ?? SolidBox();
                return new Vector3(IsFree(Locks.TurnX) ? free.x : 0, IsFree(Locks.TurnY) ? free.y : 0, IsFree(Locks.TurnZ) ? free.z : 0);
            }

            set
            {
                _inertiaTensor = value;
                _body.Change();
            }
        }

        public Quaternion inertiaTensorRotation { get => _inertiaTensorRotation; set => Set(ref _inertiaTensorRotation, value); }

        public Vector3 centerOfMass
        {
            get => _centerOfMass ?? ColliderCenter();
            set
            {
                _centerOfMass = value;
                _body.Change();
            }
        }

        public Vector3 position
        {
            get => Pose().Position;
            set => _body.MoveTo(value, Pose().Rotation);
        }

        public Quaternion rotation
        {
            get => Pose().Rotation;
            set => _body.MoveTo(Pose().Position, value);
        }

        public Vector3 angularVelocity
        {
            get => _body.AngularVelocity;
            set => _body.SetVelocities(_body.Velocity, value);
        }

        // the old names and the new ones, each only in its own version, so that a use in the wrong version does not compile
#if UNITY_6000_0_OR_NEWER || EVERY_UNITY
        public Vector3 linearVelocity { get => _body.Velocity; set => _body.SetVelocities(value, _body.AngularVelocity); }

        public float linearDamping { get => _drag; set => Set(ref _drag, value); }

        public float angularDamping { get => _angularDrag; set => Set(ref _angularDrag, value); }
#endif
#if !UNITY_6000_0_OR_NEWER
        public Vector3 velocity { get => _body.Velocity; set => _body.SetVelocities(value, _body.AngularVelocity); }

        public float drag { get => _drag; set => Set(ref _drag, value); }

        public float angularDrag { get => _angularDrag; set => Set(ref _angularDrag, value); }
#endif

        public void AddForce(Vector3 force) => AddForce(force, ForceMode.Force);

        public void AddForce(Vector3 force, ForceMode mode)
        {
            if (!IsPushed)
                return;

            Vector3 weighed = mode == ForceMode.Acceleration || mode == ForceMode.VelocityChange ? mass * force : force;
            if (mode == ForceMode.Impulse || mode == ForceMode.VelocityChange)
                _body.Kick(weighed);
            else
                _body.Push(weighed, Vector3.zero);
        }

        public void AddTorque(Vector3 torque)
        {
            if (IsPushed)
                _body.Push(Vector3.zero, torque);
        }

        public void AddRelativeForce(Vector3 force) => AddForce(rotation * force);

        public void AddRelativeTorque(Vector3 torque) => AddTorque(rotation * torque);

        public void MovePosition(Vector3 position) => this.position = position;

        public void MoveRotation(Quaternion rot) => rotation = rot;

        /// <summary>The collider's moments, in place of those that a script has set.</summary>
        public void ResetInertiaTensor()
        {
            _inertiaTensor = null;
            _inertiaTensorRotation = Quaternion.identity;
            _body.Change();
        }

        public bool IsSleeping() => _body.IsAsleep;

        public void WakeUp() => _body.WakeUp();

        public void Sleep() => _body.Sleep();

        /// <summary>One step, after which the object takes the body's pose.</summary>
        internal void Step(float step)
        {
            // a script that has moved the object has moved the body
            _body.Follow(transform.position, transform.rotation);
            if (isKinematic)
                _body.ForgetPushes();
            else
                _body.Step(step, Describe(), useGravity ? Physics.gravity : Vector3.zero);

            transform.Place(_body.Position, _body.Rotation);
            _body.Follow(transform.position, transform.rotation);
        }

        private BodyDescription Describe() => new BodyDescription("Rigidbody", MassProperties.FromPrincipal(
            mass, UnitySettings.Moments(inertiaTensor.Exact(), out Locks frozen), inertiaTensorRotation.Exact(), centerOfMass.Exact()))
        {
            Rule = Rules.UnityRigidbody,
            Lock = frozen | Locked,
            Unity = new UnitySettings
            {
                Drag = _drag,
                AngularDrag = _angularDrag,
                MaxAngularVelocity = _maxAngularVelocity,
                SleepThreshold = _sleepThreshold,
            },
        };

        // a force on any other has no effect, and is not stored
        private bool IsPushed => !isKinematic && gameObject.activeInHierarchy;

        // Unity's numbers are twice the library's
        private Locks Locked => (Locks)((int)_constraints / 2);

        private bool IsFree(Locks axis) => (Locked & axis) == 0;

        private (Vector3 Position, Quaternion Rotation) Pose()
        {
            _body.Begin(transform.position, transform.rotation);
            return (_body.Position, _body.Rotation);
        }

        private Vector3 SolidBox()
        {
            BoxCollider box = GetComponent<BoxCollider>();
            if (box == null)
                return Vector3.one;

            Vector3 edges = Vector3.Scale(box.size, transform.lossyScale), squares = Vector3.Scale(edges, edges);
            return mass / 12 * new Vector3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
        }

        private Vector3 ColliderCenter()
        {
            BoxCollider box = GetComponent<BoxCollider>();
            return box == null ? Vector3.zero : Vector3.Scale(box.center, transform.lossyScale);
        }

        private void Set<T>(ref T field, T value)
        {
            field = value;
            _body.Change();
        }
    }

    /// <summary>Axes of the world along which a body cannot move, and its own about which it cannot rotate, with Unity's numbers.</summary>
    [System.Flags]
    public enum RigidbodyConstraints
    {
        None = 0,
        FreezePositionX = 2,
        FreezePositionY = 4,
        FreezePositionZ = 8,
        FreezePosition = 14,
        FreezeRotationX = 16,
        FreezeRotationY = 32,
        FreezeRotationZ = 64,
        FreezeRotation = 112,
        FreezeAll = 126,
    }

    /// <summary>How a body is drawn between two steps.</summary>
    public enum RigidbodyInterpolation
    {
        None,
        Interpolate,
        Extrapolate,
    }

    /// <summary>The unit of a force, with Unity's numbers.</summary>
    public enum ForceMode
    {
        Force = 0,
        Impulse = 1,
        VelocityChange = 2,
        Acceleration = 5,
    }
}
