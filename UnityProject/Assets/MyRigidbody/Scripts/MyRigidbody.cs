using System;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Moves its object as a rigid body: in every fixed step it reads which keys are held, lets the library take one step,
    /// and sets the object to the new pose. The physics is in the library; the lab's integrator is in LabEuler.cs.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(100)] // it steps when all other scripts have pushed
    [AddComponentMenu("MyRigidbody/MyRigidbody")]
    public sealed partial class MyRigidbody : MonoBehaviour
    {
        [Header("Body 刚体")]
        [Tooltip("Mass in kg, above zero.\n质量，单位千克，必须大于零。")]
        public double mass = 1;

        [Tooltip("Lab Vertices: an eighth of the mass in each corner of the box, as in the lab. Solid Box: filled evenly, as Unity counts; a third of it. Mesh Vertices: the lab's sum over the object's own mesh.\n实验：八个顶点各占八分之一质量；实心长方体：与 Unity 相同，是前者的三分之一；网格：对自身网格的顶点求和。")]
        public InertiaKind inertia = InertiaKind.LabVertices;

        [Tooltip("Velocity at the start, m/s, world axes.\n初速度，米每秒，世界坐标。")]
        public Vector3 startVelocity;

        [Tooltip("Angular velocity at the start, rad/s, world axes.\n初角速度，弧度每秒，世界坐标。")]
        public Vector3 startSpin;

        [Header("Rule 方法")]
        [Tooltip("By which rule the body moves: a name of the catalogue. LabEuler is the lab's five steps, Exact turns a free body without error.\n积分器的名称。LabEuler 为实验的五个步骤，Exact 对自由转动没有误差。")]
        public string integrator = "LabEuler";

        [Header("Damping 阻尼")]
        [Tooltip("Factor Per Step: v and ω times a factor in every step, as in the lab; depends on the step. Rate: exp(-c Δt), the same at every step. None: no damping.\n每步系数：每一步 v、ω 乘以系数（与步长有关）；速率：exp(-c Δt)，与步长无关；无：没有阻尼。")]
        public DampingKind damping = DampingKind.FactorPerStep;

        [Tooltip("What is left of the velocity after a step, 0 to 1. Used by Factor Per Step.\n每一步后速度所剩的比例，0 到 1。")]
        public double linearDecay = 0.98;

        [Tooltip("What is left of the angular velocity after a step, 0 to 1. Used by Factor Per Step.\n每一步后角速度所剩的比例，0 到 1。")]
        public double angularDecay = 0.98;

        [Tooltip("c of the velocity, 1/s. Used by Rate. 1.01 is 0.98 a step at 0.02 s.\n速度的阻尼率 c，每秒。步长 0.02 秒时 1.01 相当于每步 0.98。")]
        public double linearRate = 1.01;

        [Tooltip("c of the angular velocity, 1/s. Used by Rate.\n角速度的阻尼率 c，每秒。")]
        public double angularRate = 1.01;

        [Header("What acts 作用")]
        [Tooltip("Gravity as in the project's physics settings. The lab has none.\n项目物理设置中的重力。实验中没有重力。")]
        public bool useGravity;

        [Tooltip("Arrows push with 5 N, R turns with (sin t, sin t, sin t) N m.\n方向键施加 5 牛的力，R 键施加力矩 (sin t, sin t, sin t) 牛米。")]
        public bool readsKeys = true;

        [Tooltip("The Rigidbody that this body is compared with; may be empty.\n与之比较的 Rigidbody，可为空。")]
        public DefaultRigidbody comparedWith;

        [Header("As a Rigidbody has them 与 Rigidbody 相同")]
        [Tooltip("Axes of the world along which it cannot move, and its own about which it cannot turn.\n不能沿其移动的世界坐标轴，以及不能绕其转动的自身轴。")]
        public RigidbodyConstraints constraints;

        [Tooltip("Interpolate: drawn between the last two steps, so it moves smoothly at every frame rate; State stays exact. Extrapolate is drawn as Interpolate.\n插值：画在最近两步之间，任何帧率下都平滑；State 仍是精确值。Extrapolate 与 Interpolate 相同。")]
        public RigidbodyInterpolation interpolation;

        private readonly LabKeyboard _keyboard = new LabKeyboard();
        private Simulation _simulation;
        private Vector3 _startPosition;
        private Quaternion _startRotation;
        private float _stepLength;
        private bool _isChanged, _isRefused;

        // the last pose that was shown, to find whether another script has moved the object
        private Vector3 _shownPosition;
        private Quaternion _shownRotation;

        // time and state, which Unity keeps where it loads changed scripts while playing; it does not keep the simulation
        private double[] _kept;

        /// <summary>The body and its effects, as the library got them.</summary>
        public BodyDescription Description { get; private set; }

        /// <summary>The body in motion.</summary>
        public Body Body => _simulation.Bodies[0];

        /// <summary>Its state, in double.</summary>
        public BodyState State => Body.State;

        /// <summary>False where the settings are not those of a possible body; the console says why.</summary>
        public bool IsReady => _simulation != null;

        /// <summary>Length of the steps, s.</summary>
        internal double StepLength { get; private set; }

        /// <summary>The keys that were held in the last step.</summary>
        public LabKeyboard Keyboard => _keyboard;

        /// <summary>The simulation, to save and restore it.</summary>
        internal Simulation Simulation => _simulation;

        private void Awake()
        {
            _startPosition = transform.position;
            _startRotation = transform.rotation;
            StartAgain();
        }

        private void OnEnable()
        {
            Experiment.BodiesHaveChanged();
            if (_simulation == null && _kept != null && _kept.Length > 0)
                TakeUp();
        }

        private void OnDisable() => _kept = IsReady ? Kept(_simulation.Time, State) : null;

        private void OnDestroy() => Experiment.BodiesHaveChanged();

        // Unity calls this once in every fixed step, 50 times a second whatever the frame rate. Update would be called once
        // a frame, and the motion would depend on the machine.
        private void FixedUpdate() => Step();

        // Unity calls this when a value is changed in the inspector
        private void OnValidate() => _isChanged = true;

        /// <summary>One step: keys in, pose out.</summary>
        public void Step()
        {
            // a change in the inspector is valid from here on; the body continues from its state
            if (_isChanged || Time.fixedDeltaTime != _stepLength)
                Build(goesOn: IsReady);

            // without a possible body nothing moves; the console has said why
            if (!IsReady)
                return;

            // moving the object in the editor, or by its transform, moves the body
            Follow();

            // 1. the keys: the library adds 5 N for every arrow that is held, and (sin t, sin t, sin t) N m for R
            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
                _keyboard[key] = readsKeys && LabInput.IsHeld(key);

            // 2. the step: velocity, angular velocity, position, orientation, damping; for the lab's integrator in LabEuler.cs
            TakeStep();

            // 3. the object: to the body's new pose
            Show();
        }

        /// <summary>Back to the pose and velocity of the start; t counts from 0 again.</summary>
        public void StartAgain()
        {
            WakeUp();
            Build(goesOn: false);
            Show();
        }

        /// <summary>The parts of its motion, what was left out and why: made from the plan that runs.</summary>
        public string Explain() => IsReady ? new Explanation(Body).ToString() : string.Empty;

        /// <summary>Pose and velocity of the start.</summary>
        internal BodyState StartState() =>
            new BodyState(_startPosition.Double(), _startRotation.Double(), startVelocity.Double(), startSpin.Double());

        private void Build(bool goesOn)
        {
            _isChanged = false;
            StepLength = ToUnity.Meant(_stepLength = Time.fixedDeltaTime);
            try
            {
                BodyDescription next = Describe(goesOn ? State : StartState());
                if (goesOn)
                    Body.Change(next);
                else
                    _simulation = new Simulation(TimeSteps.Every(StepLength), next);

                Description = next;
                // a corrected body moves again; a component that another script has disabled stays disabled
                enabled |= _isRefused;
                _isRefused = false;
            }
            catch (ArgumentException wrong)
            {
                Refuse("MyRigidbody on '" + name + "': " + wrong.Message);
            }
        }

        private void StepOn()
        {
            // the length of fixed steps may be changed while the game plays; time continues
            if (StepLength == _simulation.Scene.Steps.Length(0))
                _simulation.Step();
            else
                _simulation.StepBy(StepLength);
        }

        private BodyDescription Describe(BodyState start)
        {
            if (GetComponent<Rigidbody>() != null)
                throw new ArgumentException("a Rigidbody on the same object would move it too; remove one of them");

            MassProperties massProperties = InertiaOf.Object(this, mass, inertia);
            BodyDescription body = new BodyDescription(name, massProperties) { Rule = Rules.Named(integrator), Lock = Locked, Start = Held(start, massProperties) };
            if (useGravity)
                body.With(new Gravity(Physics.gravity.Double()));

            if (damping == DampingKind.FactorPerStep)
                body.With(new DecayPerStep(linearDecay, angularDecay));
            else if (damping == DampingKind.Rate)
                body.With(new LinearDamping(linearRate)).With(new AngularDamping(angularRate));

            return readsKeys ? body.With(new HeldKeys(_keyboard)) : body;
        }

        private void Refuse(string why)
        {
            _simulation = null;
            _isRefused = true;
            enabled = false;
            Debug.LogError(why, this);
        }

        private void Show()
        {
            // the library computes in double, a transform holds float; the rounded pose is not read back
            if (!IsReady)
                return;

            Put(State);
        }

        private void Put(in BodyState pose)
        {
            transform.SetPositionAndRotation(pose.Position.Float(), pose.Orientation.Float());
            _shownPosition = transform.position;
            _shownRotation = transform.rotation;
        }

        private void Follow()
        {
            // compared to the bit: Unity's == ignores a hundredth of a millimetre
            if (transform.position.Equals(_shownPosition) && transform.rotation.Equals(_shownRotation))
                return;

            BodyState here = State;
            here.Position = transform.position.Equals(_shownPosition) ? here.Position : transform.position.Double();
            here.Orientation = transform.rotation.Equals(_shownRotation) ? here.Orientation : transform.rotation.Double();
            Body.State = here;
        }

        // the scripts were reloaded: the body continues from its state, and so does t
        private void TakeUp()
        {
            double time = _kept[0];
            BodyState state = new BodyState(
                new Vector3d(_kept[1], _kept[2], _kept[3]),
                new Quaterniond(_kept[4], _kept[5], _kept[6], _kept[7]),
                new Vector3d(_kept[8], _kept[9], _kept[10]),
                new Vector3d(_kept[11], _kept[12], _kept[13]));
            _kept = null;
            Build(goesOn: false);
            if (!IsReady)
                return;

            Simulation later = new Simulation(TimeSteps.Every(StepLength));
            if (time > 0)
                later.StepBy(time);

            later.Add(Description, state);
            _simulation = later;
        }

        private static double[] Kept(double time, BodyState s) => new[]
        {
            time, s.Position.X, s.Position.Y, s.Position.Z, s.Orientation.W, s.Orientation.X, s.Orientation.Y, s.Orientation.Z,
            s.Velocity.X, s.Velocity.Y, s.Velocity.Z, s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
        };
    }

    /// <summary>How velocities are damped.</summary>
    public enum DampingKind
    {
        /// <summary>A factor in every step, as in the lab.</summary>
        FactorPerStep,

        /// <summary>exp(−c Δt): the same motion for any step length.</summary>
        Rate,

        /// <summary>No damping.</summary>
        None,
    }
}
