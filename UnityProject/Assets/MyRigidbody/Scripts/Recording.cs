using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// The motion of a body, step by step: NAME.json has the input, NAME.csv the output. For a Rigidbody the schema is
    /// free-rigid-body/1, and the command line's <c>compare NAME.json</c> prints the difference of its UnityRigidbody from it; for a student's
    /// script it is lab-script/1, and <c>compare</c> prints the difference of LabEuler from it.
    /// </summary>
    public sealed class Recording
    {
        private const string Header = "step,t,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,wakeCounter,asleep";

        // the wake counter of a body that PhysX has just set in motion, s; a script cannot read it
        private const float WakeCounter = 0.4f;

        private readonly string _name;
        private readonly StringBuilder _head = new StringBuilder();
        private readonly StringBuilder _rows = new StringBuilder(Header + "\n");
        private readonly List<Vector3> _forces = new List<Vector3>(), _torques = new List<Vector3>();
        private readonly float _dt;
        private Vector3 _force, _torque;
        private double _time;

        internal Recording(string name, Rigidbody body, float dt)
        {
            _name = name;
            _dt = dt;
            Describe(body);
        }

        internal Recording(string name, StudentBody body, float dt)
        {
            _name = name;
            _dt = dt;
            Describe(body);
        }

        /// <summary>The number of steps.</summary>
        public int Steps => _forces.Count;

        /// <summary>Adds force and torque for the next step; several add up, as in the engine.</summary>
        internal void Push(Vector3 force, Vector3 torque)
        {
            _force += force;
            _torque += torque;
        }

        /// <summary>Adds the state before a step; forces added since the last one act in this one.</summary>
        internal void Step(BodyState state, bool isAsleep)
        {
            Row(state, isAsleep);
            _forces.Add(_force);
            _torques.Add(_torque);
            _force = _torque = Vector3.zero;
        }

        /// <summary>Adds the state after the last step.</summary>
        internal void End(BodyState state, bool isAsleep) => Row(state, isAsleep);

        /// <summary>Writes both files and returns the path of the JSON.</summary>
        public string Write(string folder)
        {
            Directory.CreateDirectory(folder);
            string path = Path.Combine(folder, _name);
            File.WriteAllText(path + ".csv", _rows.ToString());
            File.WriteAllText(path + ".json", Json());
            return path + ".json";
        }

        private string Json()
        {
            StringBuilder json = new StringBuilder(_head.ToString());
            json.Append("  \"steps\": ").Append(Steps).Append(",\n");
            json.Append("  \"dt\": [").Append(string.Join(", ", System.Linq.Enumerable.Repeat(Number(_dt), Steps))).Append("],\n");
            json.Append("  \"force\": [").Append(Numbers(_forces)).Append("],\n");
            json.Append("  \"torque\": [").Append(Numbers(_torques)).Append("]\n}\n");
            return json.ToString();
        }

        private void Describe(Rigidbody body)
        {
            Quaternion q = body.rotation, frame = body.inertiaTensorRotation;
            _head.Append("{\n");
            Say("schema", "\"free-rigid-body/1\"");
            Say("name", Quoted(_name));
            Say("about", Quoted("recorded with Unity " + Application.unityVersion));
            Say("mass", Number(body.mass));
            Say("inertiaTensor", List(body.inertiaTensor));
            Say("inertiaTensorRotation", List(frame.x, frame.y, frame.z, frame.w));
            Say("centerOfMass", List(body.centerOfMass));
            Say("linearDamping", Number(EngineVersions.Drag(body)));
            Say("angularDamping", Number(EngineVersions.AngularDrag(body)));
            Say("maxAngularVelocity", Number(body.maxAngularVelocity));
            Say("sleepThreshold", Number(body.sleepThreshold));
            Say("useGravity", body.useGravity ? "true" : "false");
            Say("gyroscopicForces", "false");
            Say("gravity", List(Physics.gravity));
            Say("position", List(body.position));
            Say("rotation", List(q.x, q.y, q.z, q.w));
            Say("linearVelocity", List(EngineVersions.Velocity(body)));
            Say("angularVelocity", List(body.angularVelocity));
            Say("wakeCounter", Number(WakeCounter));
            if (body.constraints != RigidbodyConstraints.None)
                Say("lock", "{\"move\": " + Axes(body.constraints, RigidbodyConstraints.FreezePositionX) + ", \"turn\": " + Axes(body.constraints, RigidbodyConstraints.FreezeRotationX) + "}");
        }

        // Unity counts x, y, z in powers of two, from the first
        private static string Axes(RigidbodyConstraints frozen, RigidbodyConstraints first)
        {
            StringBuilder axes = new StringBuilder();
            for (int i = 0; i < 3; i++)
            {
                if (((int)frozen & ((int)first << i)) != 0)
                    axes.Append("xyz"[i]);
            }

            return Quoted(axes.ToString());
        }

        // the sheet's mass and damping, because those of the script are unknown
        private void Describe(StudentBody body)
        {
            Quaternion q = body.Transform.rotation;
            _head.Append("{\n");
            Say("schema", "\"lab-script/1\"");
            Say("name", Quoted(_name));
            Say("about", Quoted("a script recorded with Unity " + Application.unityVersion + ", a step a frame"));
            Say("mass", "1");
            Say("boxVertices", List(Positive(body.Size)));
            Say("decayPerStep", "0.98");
            Say("position", List(body.Transform.position));
            Say("rotation", List(q.x, q.y, q.z, q.w));
        }

        // a mirrored object has a scale below zero, and the same box
        private static Vector3 Positive(Vector3 v) => new Vector3(Mathf.Abs(v.x), Mathf.Abs(v.y), Mathf.Abs(v.z));

        private void Say(string what, string value) => _head.Append("  \"").Append(what).Append("\": ").Append(value).Append(",\n");

        private void Row(BodyState s, bool isAsleep)
        {
            Quaterniond q = s.Orientation;
            _rows.Append(_forces.Count).Append(',').Append(Number((float)_time)).Append(',');
            _rows.Append(string.Join(",", Numbers(s.Position), Number(q.X), Number(q.Y), Number(q.Z), Number(q.W)));
            _rows.Append(',').Append(Numbers(s.Velocity)).Append(',').Append(Numbers(s.AngularVelocity));
            _rows.Append(",0,").Append(isAsleep ? "1\n" : "0\n");
            _time += _dt;
        }

        private static string Quoted(string text)
        {
            StringBuilder quoted = new StringBuilder("\"");
            foreach (char c in text)
            {
                if (c == '"' || c == '\\')
                    quoted.Append('\\').Append(c);
                else if (c < ' ')
                    quoted.Append("\\u").Append(((int)c).ToString("x4"));
                else
                    quoted.Append(c);
            }

            return quoted.Append('"').ToString();
        }

        private static string List(Vector3 v) => List(v.x, v.y, v.z);

        private static string List(params float[] numbers) => "[" + string.Join(", ", System.Array.ConvertAll(numbers, n => Number(n))) + "]";

        private static string Numbers(List<Vector3> vectors)
        {
            List<string> numbers = new List<string>(3 * vectors.Count);
            foreach (Vector3 v in vectors)
                numbers.AddRange(new[] { Number(v.x), Number(v.y), Number(v.z) });

            return string.Join(", ", numbers);
        }

        private static string Numbers(Vector3d v) => Number(v.X) + "," + Number(v.Y) + "," + Number(v.Z);

        // with nine digits every float is read back to the bit
        private static string Number(double number) => ((float)number).ToString("g9", CultureInfo.InvariantCulture);
    }
}
