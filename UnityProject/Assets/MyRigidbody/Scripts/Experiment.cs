using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>Controls the bodies of the scene together: pause, one step, slow motion, start again, record.</summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("MyRigidbody/Experiment")]
    public sealed class Experiment : MonoBehaviour
    {
        private const float Slow = 0.1f;
        private static int _comings;
        private readonly List<MyRigidbody> _mine = new List<MyRigidbody>();
        private readonly List<DefaultRigidbody> _theirs = new List<DefaultRigidbody>();
        private readonly List<StudentBody> _students = new List<StudentBody>();
        private bool _isPaused, _isSlow;
        private int _steps;

        // the time scale that other scripts have set, and the one that was last set here
        private float _theirScale = 1, _ourScale = -1;

        // the frame in which the lists were filled; Unity keeps private fields while it loads changed scripts, but no readonly lists
        [System.NonSerialized]
        private int _gathered = -1;

        /// <summary>The bodies moved by the library, in the order of the scene's hierarchy. Valid from Start on.</summary>
        public IReadOnlyList<MyRigidbody> Mine
        {
            get
            {
                Gather();
                return _mine;
            }
        }

        /// <summary>The bodies moved by the engine, in the order of the scene's hierarchy. Valid from Start on.</summary>
        public IReadOnlyList<DefaultRigidbody> Theirs
        {
            get
            {
                Gather();
                return _theirs;
            }
        }

        /// <summary>The bodies moved by a student's own script, in the order of the scene's hierarchy. Valid from Start on.</summary>
        public IReadOnlyList<StudentBody> Students
        {
            get
            {
                Gather();
                return _students;
            }
        }

        /// <summary>Fixed steps since the start.</summary>
        public int Steps => _steps;

        /// <summary>Time since the start, s.</summary>
        public double Seconds => Steps * ToUnity.Meant(Time.fixedDeltaTime);

        /// <summary>True while nothing moves.</summary>
        public bool IsPaused
        {
            get => _isPaused;
            set
            {
                if (value == _isPaused)
                    return;

                _isPaused = value;
                SetTimeScale(isOurs: true);
                foreach (StudentBody body in _students)
                    body.Hold(value);
            }
        }

        /// <summary>True while everything runs at a tenth of its speed: the same steps, a tenth as often.</summary>
        public bool IsSlow
        {
            get => _isSlow;
            set
            {
                if (value == _isSlow)
                    return;

                _isSlow = value;
                SetTimeScale(isOurs: true);
            }
        }

        /// <summary>True while the engine's bodies and the students' are recorded.</summary>
        public bool IsRecording => _theirs.Exists(body => body.Recording != null) || _students.Exists(body => body.Recording != null);

        /// <summary>The path of the last recording.</summary>
        public string LastRecording { get; private set; }

        /// <summary>Called when a body is added or removed, so that the lists are filled again.</summary>
        internal static void BodiesHaveChanged() => _comings++;

        private void Start() => Gather();

        private void OnEnable()
        {
            if (_isPaused || _isSlow)
                SetTimeScale(isOurs: true);
            if (_isPaused)
                _students.ForEach(body => body.Hold(true));
        }

        // a body just added must not be changed in the step that follows
        private void FixedUpdate()
        {
            Gather();
            _steps++;
        }

        private void LateUpdate()
        {
            foreach (StudentBody body in Students)
                body.Look();
        }

        private void OnDisable()
        {
            SetTimeScale(isOurs: false);
            foreach (StudentBody body in _students)
                body.Hold(false);
        }

        private void OnApplicationFocus(bool hasFocus)
        {
            if (!hasFocus)
                LabInput.LetGo();
        }

        private void OnApplicationPause(bool isPaused)
        {
            if (isPaused)
                LabInput.LetGo();
        }

        /// <summary>One fixed step of all bodies, including the engine's; pauses before it. A student's script runs in the next frame.</summary>
        public void StepOnce()
        {
            IsPaused = true;
            foreach (MyRigidbody body in Mine)
            {
                if (body.isActiveAndEnabled)
                    body.Step();
            }

            foreach (DefaultRigidbody body in Theirs)
            {
                if (body.isActiveAndEnabled)
                    body.Step();
            }

            foreach (StudentBody body in Students)
                body.StepOnce();

            List<ExactRotation> exact = gameObject.scene.GetRootGameObjects()
                .SelectMany(root => root.GetComponentsInChildren<ExactRotation>()).Where(body => body.enabled).ToList();
            exact.ForEach(body => body.BeforeSimulate(Time.fixedDeltaTime));
            EngineVersions.StepPhysics();
            exact.ForEach(body => body.AfterSimulate());
            _steps++;
        }

        /// <summary>All bodies back to their starts, with their present settings.</summary>
        public void StartAgain()
        {
            foreach (MyRigidbody body in Mine)
                body.StartAgain();

            foreach (DefaultRigidbody body in Theirs)
                body.StartAgain();

            foreach (StudentBody body in Students)
                body.StartAgain();

            _steps = 0;
            KeepApart();
        }

        /// <summary>Starts again and records the engine's bodies and the students' from there.</summary>
        public void Record()
        {
            StartAgain();
            string now = System.DateTime.Now.ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
            foreach (DefaultRigidbody body in Theirs)
                body.Record(FileName(body.name) + "-" + now);

            foreach (StudentBody body in _students.FindAll(body => body.IsThere))
                body.Record(FileName(body.Name) + "-script-" + now);
        }

        /// <summary>Ends the recordings and writes them; the console and <see cref="LastRecording"/> name the files.</summary>
        public void EndRecording() => EndRecording(Path.Combine(Application.persistentDataPath, "recordings"));

        /// <summary>Ends the recordings and writes them into a folder.</summary>
        public void EndRecording(string folder)
        {
            foreach (DefaultRigidbody body in Theirs)
                Write(body.EndRecording(), folder);

            foreach (StudentBody body in Students)
                Write(body.EndRecording(), folder);
        }

        private void Write(Recording recording, string folder)
        {
            if (recording == null || recording.Steps == 0)
                return;

            try
            {
                LastRecording = recording.Write(folder);
                Debug.Log("recorded: " + LastRecording, this);
            }
            catch (System.Exception refused) when (refused is IOException || refused is System.UnauthorizedAccessException)
            {
                Debug.LogError("The recording could not be written: " + refused.Message, this);
            }
        }

        // in Awake the scene is not loaded yet, and Unity does not list its objects
        private void Gather()
        {
            int now = _comings + gameObject.scene.rootCount;
            if (_gathered == now)
                return;

            _gathered = now;
            List<StudentBody> before = new List<StudentBody>(_students);
            _mine.Clear();
            _theirs.Clear();
            _students.Clear();
            foreach (GameObject root in gameObject.scene.GetRootGameObjects())
            {
                _mine.AddRange(root.GetComponentsInChildren<MyRigidbody>());
                _theirs.AddRange(root.GetComponentsInChildren<DefaultRigidbody>());
                foreach (MonoBehaviour script in root.GetComponentsInChildren<MonoBehaviour>())
                {
                    if (StudentBody.Is(script))
                        _students.Add(before.Find(body => body.IsThere && body.Transform == script.transform) ?? new StudentBody(script));
                }
            }

            foreach (StudentBody body in _students)
            {
                body.Mine = _mine.Find(mine => StudentBody.SizeOf(mine.transform) == body.Size);
                body.Theirs = _theirs.Find(theirs => StudentBody.SizeOf(theirs.transform) == body.Size);
                body.Hold(_isPaused);
            }

            KeepApart();
        }

        // compared bodies must not touch: a collision caused by a key is another experiment
        private void KeepApart()
        {
            List<Collider> colliders = new List<Collider>();
            _mine.ForEach(body => colliders.AddRange(body.GetComponentsInChildren<Collider>()));
            _theirs.ForEach(body => colliders.AddRange(body.GetComponentsInChildren<Collider>()));
            foreach (StudentBody body in _students.FindAll(body => body.IsThere))
                colliders.AddRange(body.Transform.GetComponentsInChildren<Collider>());

            for (int i = 0; i < colliders.Count; i++)
            {
                for (int j = 0; j < i; j++)
                    Physics.IgnoreCollision(colliders[i], colliders[j]);
            }
        }

        // another script may set the time scale, too: its value is kept, and restored when nothing is paused or slow here
        private void SetTimeScale(bool isOurs)
        {
            if (Time.timeScale != _ourScale)
                _theirScale = Time.timeScale;

            float scale = !isOurs ? _theirScale : _isPaused ? 0 : _isSlow ? Slow * _theirScale : _theirScale;
            Time.timeScale = _ourScale = scale;
        }

        private static string FileName(string name)
        {
            foreach (char c in Path.GetInvalidFileNameChars())
                name = name.Replace(c, '_');

            return name.Replace(' ', '-');
        }
    }
}
