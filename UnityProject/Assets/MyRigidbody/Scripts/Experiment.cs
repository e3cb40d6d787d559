using System.Collections.Generic;
using System.Globalization;
using System.IO;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>Holds the bodies of the scene together: pause, one step, slow motion, start again, record.</summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("MyRigidbody/Experiment")]
    public sealed class Experiment : MonoBehaviour
    {
        private const float Slow = 0.1f;
        private readonly List<MyRigidbody> _mine = new List<MyRigidbody>();
        private readonly List<DefaultRigidbody> _theirs = new List<DefaultRigidbody>();
        private readonly List<StudentBody> _students = new List<StudentBody>();
        private bool _isPaused, _isSlow, _hasGathered;

        /// <summary>The bodies moved by the library, in the order of the scene's hierarchy. To be asked from Start on.</summary>
        public IReadOnlyList<MyRigidbody> Mine
        {
            get
            {
                Gather();
                return _mine;
            }
        }

        /// <summary>The bodies moved by the engine, in the order of the scene's hierarchy. To be asked from Start on.</summary>
        public IReadOnlyList<DefaultRigidbody> Theirs
        {
            get
            {
                Gather();
                return _theirs;
            }
        }

        /// <summary>The bodies moved by a student's own script, in the order of the scene's hierarchy. To be asked from Start on.</summary>
        public IReadOnlyList<StudentBody> Students
        {
            get
            {
                Gather();
                return _students;
            }
        }

        /// <summary>Fixed steps since the start.</summary>
        public int Steps { get; private set; }

        /// <summary>Time since the start, s.</summary>
        public double Seconds => Steps * ToUnity.Meant(Time.fixedDeltaTime);

        /// <summary>True while nothing moves.</summary>
        public bool IsPaused
        {
            get => _isPaused;
            set
            {
                _isPaused = value;
                SetTimeScale();
                foreach (StudentBody body in _students)
                    body.Hold(value);
            }
        }

        /// <summary>True while all runs at a tenth of its speed: the same steps, a tenth as often.</summary>
        public bool IsSlow
        {
            get => _isSlow;
            set
            {
                _isSlow = value;
                SetTimeScale();
            }
        }

        /// <summary>True while the engine's bodies and the students' are recorded.</summary>
        public bool IsRecording => _theirs.Exists(body => body.Recording != null) || _students.Exists(body => body.Recording != null);

        /// <summary>Where the last recording was written.</summary>
        public string LastRecording { get; private set; }

        private void Start() => Gather();

        private void FixedUpdate() => Steps++;

        private void LateUpdate()
        {
            foreach (StudentBody body in Students)
                body.Look();
        }

        private void OnDisable()
        {
            Time.timeScale = 1;
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

        /// <summary>One fixed step of all bodies, those of the engine too; pauses before it. A student's script has the next frame.</summary>
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

            EngineVersions.StepPhysics();
            Steps++;
        }

        /// <summary>All bodies back to their starts, with their settings as they now are.</summary>
        public void StartAgain()
        {
            foreach (MyRigidbody body in Mine)
                body.StartAgain();

            foreach (DefaultRigidbody body in Theirs)
                body.StartAgain();

            foreach (StudentBody body in Students)
                body.StartAgain();

            Steps = 0;
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

        /// <summary>Ends the recordings and writes them; the console and <see cref="LastRecording"/> say where.</summary>
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

        // in Awake the scene is not loaded yet, and Unity would not say what is in it
        private void Gather()
        {
            if (_hasGathered)
                return;

            _hasGathered = true;
            foreach (GameObject root in gameObject.scene.GetRootGameObjects())
            {
                _mine.AddRange(root.GetComponentsInChildren<MyRigidbody>());
                _theirs.AddRange(root.GetComponentsInChildren<DefaultRigidbody>());
                foreach (MonoBehaviour script in root.GetComponentsInChildren<MonoBehaviour>())
                {
                    if (StudentBody.Is(script))
                        _students.Add(new StudentBody(script));
                }
            }

            foreach (StudentBody body in _students)
            {
                body.Mine = _mine.Find(mine => StudentBody.SizeOf(mine.transform) == body.Size);
                body.Theirs = _theirs.Find(theirs => StudentBody.SizeOf(theirs.transform) == body.Size);
                body.Hold(_isPaused);
            }
        }

        private void SetTimeScale() => Time.timeScale = _isPaused ? 0 : _isSlow ? Slow : 1;

        private static string FileName(string name)
        {
            foreach (char c in Path.GetInvalidFileNameChars())
                name = name.Replace(c, '_');

            return name.Replace(' ', '-');
        }
    }
}
