using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// The course's script for Unity's own Rigidbody: the same keys give the same force and torque, and the engine moves
    /// the body by its own integrator. MyRigidbody is compared with it.
    /// </summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(Rigidbody))]
    [AddComponentMenu("MyRigidbody/DefaultRigidbody")]
    public sealed class DefaultRigidbody : MonoBehaviour
    {
        private const float Push = 5;
        private const float UnityMaxSpin = 7, NoMaxSpin = 1e6f;

        [Header("As in the course 与课程相同")]
        [Tooltip("Push in Update, as the course's script does: then the force acts once a frame, and the motion depends on the frame rate.\n像课程脚本那样在 Update 中施力：每帧施力一次，运动与帧率有关。")]
        public bool pushesInUpdate;

        [Header("Where it is unlike MyRigidbody 与 MyRigidbody 不同之处")]
        [Tooltip("Rigidbody.drag, 1/s. 1 is the lab's 0.98 a step at 0.02 s.\n线性阻尼，每秒。步长 0.02 秒时 1 恰为实验的每步 0.98。")]
        public float drag;

        [Tooltip("Rigidbody.angularDrag, 1/s.\n角阻尼，每秒。")]
        public float angularDrag = 0.05f;

        [Tooltip("Unity keeps every Rigidbody below 7 rad/s. Off: no such limit.\nUnity 默认把角速度限制在 7 弧度每秒以内。关闭则不限制。")]
        public bool limitsSpin = true;

        [Tooltip("The lab's inertia, an eighth of the mass in each corner: three times that of Unity's solid box.\n使用实验的转动惯量（八个顶点），是 Unity 实心长方体的三倍。")]
        public bool hasLabInertia;

        [Header("Start 初值")]
        [Tooltip("Velocity at the start, m/s.\n初速度，米每秒。")]
        public Vector3 startVelocity;

        [Tooltip("Angular velocity at the start, rad/s.\n初角速度，弧度每秒。")]
        public Vector3 startSpin;

        private Rigidbody _body;
        private Vector3 _startPosition;
        private Quaternion _startRotation;
        private int _steps;

        /// <summary>The motion being recorded; null if none is.</summary>
        public Recording Recording { get; private set; }

        /// <summary>Its state in the engine.</summary>
        public BodyState State => new BodyState(
            _body.position.Double(), _body.rotation.Double(), EngineVersions.Velocity(_body).Double(), _body.angularVelocity.Double());

        /// <summary>Its mass and inertia in the engine.</summary>
        public MassProperties Mass => MassProperties.FromPrincipal(
            _body.mass, UnitySettings.Moments(_body.inertiaTensor.Double(), out _), _body.inertiaTensorRotation.Double(), _body.centerOfMass.Double());

        private void Awake()
        {
            _body = GetComponent<Rigidbody>();
            _startPosition = transform.position;
            _startRotation = transform.rotation;
            StartAgain();
        }

        private void OnEnable() => Experiment.BodiesHaveChanged();

        private void OnDestroy() => Experiment.BodiesHaveChanged();

        // once in every fixed step, just before the engine moves its bodies: a force added here acts for that one step
        private void FixedUpdate() => Step();

        // once a frame: at 200 frames a second four times in every fixed step, and the forces add up
        private void Update()
        {
            if (pushesInUpdate && Time.timeScale > 0)
                AddPushes();
        }

        /// <summary>Adds the keys' force and torque before a step of the engine.</summary>
        public void Step()
        {
            // force and torque of the keys; the engine sums them until its next step (while paused, one step is one frame)
            if (!pushesInUpdate || Time.timeScale == 0)
                AddPushes();

            // the state before that step, and the force and torque in it
            if (Recording != null)
                Recording.Step(State, _body.IsSleeping());

            // t of the torque; the engine itself now moves the body: v, damping, limit of ω, x, q
            _steps++;
        }

        /// <summary>Back to the start, with the present settings.</summary>
        public void StartAgain()
        {
            Recording = null;
            _steps = 0;
            EngineVersions.SetDrag(_body, drag, angularDrag);
            _body.maxAngularVelocity = limitsSpin ? UnityMaxSpin : NoMaxSpin;
            _body.ResetInertiaTensor();
            if (hasLabInertia)
            {
                MassProperties lab = InertiaOf.Object(this, _body.mass, InertiaKind.LabVertices);
                _body.inertiaTensor = lab.PrincipalMoments.Float();
                _body.inertiaTensorRotation = lab.PrincipalFrame.Float();
            }

            transform.SetPositionAndRotation(_startPosition, _startRotation);
            _body.position = _startPosition;
            _body.rotation = _startRotation;
            EngineVersions.SetVelocity(_body, startVelocity);
            _body.angularVelocity = startSpin;
            _body.WakeUp();
        }

        /// <summary>Pose and velocity of the start.</summary>
        internal BodyState StartState() =>
            new BodyState(_startPosition.Double(), _startRotation.Double(), startVelocity.Double(), startSpin.Double());

        /// <summary>Starts again and records from there, under a file name.</summary>
        public void Record(string fileName)
        {
            StartAgain();
            Recording = new Recording(fileName, _body, Time.fixedDeltaTime);
        }

        /// <summary>Ends the recording with the present state, and returns it.</summary>
        public Recording EndRecording()
        {
            Recording ended = Recording;
            Recording = null;
            if (ended != null)
                ended.End(State, _body.IsSleeping());

            return ended;
        }

        private void AddPushes()
        {
            // each arrow applies 5 N to the centre of mass along an axis of the world
            Vector3 force = Vector3.zero;
            if (LabInput.IsHeld(LabKey.LeftArrow))
                force += new Vector3(-Push, 0, 0);
            if (LabInput.IsHeld(LabKey.RightArrow))
                force += new Vector3(Push, 0, 0);
            if (LabInput.IsHeld(LabKey.UpArrow))
                force += new Vector3(0, Push, 0);
            if (LabInput.IsHeld(LabKey.DownArrow))
                force += new Vector3(0, -Push, 0);

            // R applies the torque (sin t, sin t, sin t) N m, t the time since the start
            Vector3 torque = Vector3.zero;
            if (LabInput.IsHeld(LabKey.R))
                torque = Vector3.one * Mathf.Sin(_steps * Time.fixedDeltaTime);

            // a force of zero would wake a sleeping body
            if (force != Vector3.zero)
                _body.AddForce(force);
            if (torque != Vector3.zero)
                _body.AddTorque(torque);

            if (Recording != null)
                Recording.Push(force, torque);
        }
    }
}
