using System;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// An object that a student's own script moves: a component called MyRigidbody in no namespace. Only its pose after every frame is
    /// known, as the lab's sheet steps in Update; velocity and angular velocity are differences of the pose.
    /// </summary>
    public sealed class StudentBody
    {
        private const float Push = 5;

        private readonly GameObject _object;
        private readonly Type _type;
        private readonly string _settings;
        private readonly Vector3 _startPosition;
        private readonly Quaternion _startRotation;
        private MonoBehaviour _script;
        private BodyState _inSteps;
        private bool _isHeld, _isStepping;
        private int _startFrame = -1;

        internal StudentBody(MonoBehaviour script)
        {
            _script = script;
            _object = script.gameObject;
            _type = script.GetType();
            // the values of the inspector; an added component has its defaults
            _settings = JsonUtility.ToJson(script);
            _startPosition = _object.transform.position;
            _startRotation = _object.transform.rotation;
            State = _inSteps = AtStart;
        }

        /// <summary>The object's name.</summary>
        public string Name => _object.name;

        /// <summary>Where the object is.</summary>
        public Transform Transform => _object.transform;

        /// <summary>False once the object or its script has been destroyed.</summary>
        public bool IsThere => _script != null;

        /// <summary>Its pose after the last frame; velocity and angular velocity are the change of the pose over the frame's time.</summary>
        public BodyState State { get; private set; }

        /// <summary>Frames since the start: the steps of a script that steps in Update.</summary>
        public int Frames { get; private set; }

        /// <summary>The first body of ours with the same box; null if there is none.</summary>
        public MyRigidbody Mine { get; internal set; }

        /// <summary>The first body of Unity's with the same box; null if there is none.</summary>
        public DefaultRigidbody Theirs { get; internal set; }

        /// <summary>The motion being recorded; null if none is.</summary>
        public Recording Recording { get; private set; }

        /// <summary>Edges of its box, m, in the scene.</summary>
        internal Vector3 Size => SizeOf(_object.transform);

        private BodyState AtStart => new BodyState(_startPosition.Double(), _startRotation.Double(), Vector3d.Zero, Vector3d.Zero);

        /// <summary>True for a script of a student.</summary>
        public static bool Is(MonoBehaviour script) =>
            script != null && script.GetType().Name == "MyRigidbody" && string.IsNullOrEmpty(script.GetType().Namespace);

        /// <summary>Distance between the displacements of this and another body since their starts, m.</summary>
        public double DistanceTo(BodyState start, BodyState now) =>
            (State.Position - AtStart.Position - (now.Position - start.Position)).Length;

        /// <summary>Angle between the rotations of this and another body since their starts, rad.</summary>
        public double AngleTo(BodyState start, BodyState now) =>
            Conserved.AngleBetween(State.Orientation * AtStart.Orientation.Conjugate, now.Orientation * start.Orientation.Conjugate);

        /// <summary>
        /// Back to the start: the pose, and a new script with the values of the inspector. Changes of other objects by the script stay, and
        /// references to the old script become invalid.
        /// </summary>
        public void StartAgain()
        {
            Recording = null;
            Frames = 0;
            State = _inSteps = AtStart;
            if (!IsThere)
                return;

            bool isActive = _object.activeSelf, isEnabled = _script.enabled || _isHeld;
            // the values must be set before Awake, so the object is inactive until then
            _object.SetActive(false);
            UnityEngine.Object.DestroyImmediate(_script);
            _script = (MonoBehaviour)_object.AddComponent(_type);
            JsonUtility.FromJsonOverwrite(_settings, _script);
            _script.enabled = isEnabled && !_isHeld;
            _object.transform.SetPositionAndRotation(_startPosition, _startRotation);
            _object.SetActive(isActive);
            _startFrame = Time.frameCount;
            _isStepping = false;
        }

        /// <summary>Starts again and records from there, under a file name.</summary>
        public void Record(string fileName)
        {
            StartAgain();
            Recording = new Recording(fileName, this, Time.fixedDeltaTime);
        }

        /// <summary>Ends the recording with the present pose, and returns it.</summary>
        public Recording EndRecording()
        {
            Recording ended = Recording;
            Recording = null;
            if (ended != null)
                ended.End(_inSteps, false);

            return ended;
        }

        /// <summary>Stops or resumes the script: Update is called while the game is paused, too.</summary>
        internal void Hold(bool isHeld)
        {
            if (!IsThere || isHeld == _isHeld || (isHeld && !_script.enabled))
                return;

            _isHeld = isHeld;
            _isStepping = false;
            _script.enabled = !isHeld;
        }

        /// <summary>Lets a stopped script have the next frame.</summary>
        internal void StepOnce()
        {
            if (!IsThere || !_isHeld)
                return;

            _isStepping = true;
            _script.enabled = true;
        }

        /// <summary>Called after every script has had its Update.</summary>
        internal void Look()
        {
            // a script just added has its first Update in the next frame
            if (!IsThere || !_script.isActiveAndEnabled || Time.frameCount == _startFrame)
                return;

            if (Recording != null)
            {
                Recording.Push(Force(), LabInput.IsOnKeyboard(LabKey.R) ? Vector3.one * Mathf.Sin(Time.time) : Vector3.zero);
                Recording.Step(_inSteps, false);
            }

            float step = Time.fixedDeltaTime;
            _inSteps = MovedFrom(State, step);
            State = MovedFrom(State, Time.deltaTime > 0 ? Time.deltaTime : step);
            Frames++;
            if (!_isStepping)
                return;

            _isStepping = false;
            _script.enabled = false;
        }

        internal static Vector3 SizeOf(Transform body)
        {
            MeshFilter filter = body.GetComponent<MeshFilter>();
            Vector3 scale = body.lossyScale;
            return filter == null || filter.sharedMesh == null ? scale : Vector3.Scale(filter.sharedMesh.bounds.size, scale);
        }

        // a student's script reads only the keyboard, not the buttons on the screen
        private static Vector3 Force() => Push * new Vector3(
            Held(LabKey.RightArrow) - Held(LabKey.LeftArrow), Held(LabKey.UpArrow) - Held(LabKey.DownArrow), 0);

        private static int Held(LabKey key) => LabInput.IsOnKeyboard(key) ? 1 : 0;

        private BodyState MovedFrom(BodyState before, double time)
        {
            Vector3d position = Transform.position.Double();
            Quaterniond orientation = Transform.rotation.Double(), turn = orientation * before.Orientation.Conjugate;
            // the shorter rotation: 2 atan(|v| / w) about v
            double sine = turn.Vector.Length, angle = 2 * Math.Atan2(sine, Math.Abs(turn.W));
            double rate = sine > 0 ? (turn.W < 0 ? -angle : angle) / (sine * time) : 0;
            return new BodyState(position, orientation, 1 / time * (position - before.Position), rate * turn.Vector);
        }
    }
}
