using System;
using System.Linq;
using System.Reflection;
using RigidBodyDynamics.Judging;
using UnityEngine;

namespace RigidBodyDynamics.Starter
{
    /// <summary>A script on a hidden object of the editor, driven by the judge. Its messages are called directly, with keys and a clock of our own.</summary>
    internal sealed class EditorLaboratory : ILaboratory, IDisposable
    {
        private const BindingFlags Members = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

        private readonly Type _script, _input, _time;
        private GameObject _object;
        private MonoBehaviour _behaviour;

        /// <param name="assembly">The script, compiled together with <see cref="KeysAndClock"/>.</param>
        /// <param name="script">Its class.</param>
        public EditorLaboratory(Assembly assembly, Type script)
        {
            _script = script;
            _input = assembly.GetType("Input", throwOnError: true);
            _time = assembly.GetType("Time", throwOnError: true);
        }

        public Pose Pose
        {
            get
            {
                Vector3 x = _object.transform.position;
                UnityEngine.Quaternion q = _object.transform.rotation;
                return new Pose(new Vector(x.x, x.y, x.z), new Orientation(q.x, q.y, q.z, q.w));
            }

            set
            {
                _object.transform.position = Float(value.Position);
                Orientation q = value.Orientation;
                _object.transform.rotation = new UnityEngine.Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
            }
        }

        public Action<Keys> KeyAsked
        {
            set => Set(_input, "Asked", value == null ? null : new Action<int>(key => value((Keys)key)));
        }

        public object Begin(Setting setting)
        {
            Dispose();
            _object = GameObject.CreatePrimitive(PrimitiveType.Cube);
            _object.hideFlags = HideFlags.HideAndDontSave;
            _object.transform.localScale = Float(setting.Scale);
            MeshFilter filter = _object.GetComponent<MeshFilter>();
            filter.sharedMesh = new Mesh { vertices = setting.Vertices.Select(Float).ToArray() };
            Clock(0, 0, FrameInput.FixedDelta);
            Set(_input, "Held", 0);
            _behaviour = (MonoBehaviour)_object.AddComponent(_script);
            Pose = setting.Pose;
            return _behaviour;
        }

        public void Start()
        {
            Send("Awake");
            Send("OnEnable");
            Send("Start");
        }

        public void Frame(FrameInput input)
        {
            Set(_input, "Before", Get(_input, "Held"));
            Set(_input, "Held", (int)input.Held);
            Clock(input.Number, input.Time, FrameInput.FixedDelta);
            Send("FixedUpdate");
            Clock(input.Number, input.Time, input.Delta);
            Send("Update");
            Send("LateUpdate");
        }

        public void Dispose()
        {
            if (_object == null)
                return;

            Mesh mesh = _object.GetComponent<MeshFilter>().sharedMesh;
            UnityEngine.Object.DestroyImmediate(_object);
            if (mesh != null)
                UnityEngine.Object.DestroyImmediate(mesh);
            _object = null;
        }

        private void Clock(int number, double time, double delta)
        {
            Set(_time, "frameCount", number);
            foreach (string name in new[] { "time", "fixedTime", "timeSinceLevelLoad", "unscaledTime", "realtimeSinceStartup" })
                Set(_time, name, (float)time);
            foreach (string name in new[] { "deltaTime", "unscaledDeltaTime", "smoothDeltaTime" })
                Set(_time, name, (float)delta);
        }

        // the engine also calls private messages of a base class
        private void Send(string message)
        {
            for (Type type = _script; type != null && type != typeof(MonoBehaviour); type = type.BaseType)
            {
                MethodInfo method = type.GetMethod(message, Members | BindingFlags.DeclaredOnly, null, Type.EmptyTypes, null);
                if (method == null)
                    continue;

                try
                {
                    method.Invoke(_behaviour, null);
                }
                catch (TargetInvocationException thrown)
                {
                    throw new InvalidOperationException(message + ": " + thrown.InnerException.Message, thrown.InnerException);
                }

                return;
            }
        }

        private static void Set(Type type, string field, object value) => type.GetField(field).SetValue(null, value);

        private static object Get(Type type, string field) => type.GetField(field).GetValue(null);

        private static Vector3 Float(Vector v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);
    }
}
