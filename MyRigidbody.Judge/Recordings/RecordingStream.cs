using System.Collections.Generic;
using System.IO;
using System.Text;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Writes a recording as numbers in the order of its members.</summary>
    internal sealed class RecordingWriter
    {
        private readonly BinaryWriter _out;

        public RecordingWriter(Stream stream) => _out = new BinaryWriter(stream, Encoding.UTF8, true);

        public void Recording(Recording recording)
        {
            _out.Write(recording.Runs.Count);
            foreach (Run run in recording.Runs)
                Run(run);
            _out.Write(recording.Variables.Count);
            foreach (KeyValuePair<string, string> variable in recording.Variables)
            {
                _out.Write(variable.Key);
                _out.Write(variable.Value);
            }

            _out.Flush();
        }

        private void Run(Run run)
        {
            _out.Write(run.Name);
            Pose(run.Setting.Pose);
            Vector(run.Setting.Scale);
            _out.Write(run.Setting.Vertices.Count);
            foreach (Vector vertex in run.Setting.Vertices)
                Vector(vertex);
            Maybe(run.InertiaAtStart);
            _out.Write(run.Frames.Count);
            foreach (Frame frame in run.Frames)
                Frame(frame);
        }

        private void Frame(Frame frame)
        {
            _out.Write(frame.Input.Number);
            _out.Write(frame.Input.Time);
            _out.Write(frame.Input.Delta);
            _out.Write((int)frame.Input.Held);
            Snapshot(frame.Before);
            Snapshot(frame.After);
            _out.Write(frame.IsSetAnew);
            Maybe(frame.GivenForce);
            Maybe(frame.GivenTorque);
        }

        private void Snapshot(Snapshot s)
        {
            Pose(new Pose(s.Position, s.Orientation));
            _out.Write(s.OwnOrientation.HasValue);
            if (s.OwnOrientation.HasValue)
                Orientation(s.OwnOrientation.Value);
            Maybe(s.Velocity);
            Maybe(s.AngularVelocity);
            Maybe(s.Force);
            Maybe(s.Torque);
            _out.Write(s.Mass.HasValue);
            if (s.Mass.HasValue)
                _out.Write(s.Mass.Value);
            Maybe(s.Inertia);
        }

        private void Pose(Pose pose)
        {
            Vector(pose.Position);
            Orientation(pose.Orientation);
        }

        private void Maybe(Vector? v)
        {
            _out.Write(v.HasValue);
            if (v.HasValue)
                Vector(v.Value);
        }

        private void Maybe(Matrix? m)
        {
            _out.Write(m.HasValue);
            if (!m.HasValue)
                return;
            Vector(m.Value.Row0);
            Vector(m.Value.Row1);
            Vector(m.Value.Row2);
        }

        private void Vector(Vector v)
        {
            _out.Write(v.X);
            _out.Write(v.Y);
            _out.Write(v.Z);
        }

        private void Orientation(Orientation q)
        {
            Vector(q.Imaginary);
            _out.Write(q.W);
        }
    }

    /// <summary>Reads the output of <see cref="RecordingWriter"/>.</summary>
    internal sealed class RecordingReader
    {
        /// <summary>More runs, vertices or frames than any experiment has: the stream is not a recording.</summary>
        private const int TooMany = 100000;

        private readonly BinaryReader _in;

        public RecordingReader(Stream stream) => _in = new BinaryReader(stream, Encoding.UTF8, true);

        public Recording Recording()
        {
            List<Run> runs = new List<Run>();
            for (int left = Count(); left > 0; left--)
                runs.Add(Run());
            Dictionary<string, string> variables = new Dictionary<string, string>();
            for (int left = Count(); left > 0; left--)
                variables[_in.ReadString()] = _in.ReadString();
            return new Recording(runs, variables);
        }

        private int Count()
        {
            int count = _in.ReadInt32();
            return count >= 0 && count < TooMany ? count : throw new InvalidDataException($"A recording cannot have {count} of anything.");
        }

        private Run Run()
        {
            string name = _in.ReadString();
            Pose pose = Pose();
            Vector scale = Vector();
            List<Vector> vertices = new List<Vector>();
            for (int left = Count(); left > 0; left--)
                vertices.Add(Vector());
            Matrix? inertia = MaybeMatrix();
            List<Frame> frames = new List<Frame>();
            for (int left = Count(); left > 0; left--)
                frames.Add(Frame());
            return new Run(name, new Setting(pose, scale, vertices), inertia, frames);
        }

        private Frame Frame()
        {
            FrameInput input = new FrameInput(_in.ReadInt32(), _in.ReadDouble(), _in.ReadDouble(), (Keys)_in.ReadInt32());
            return new Frame(input, Snapshot(), Snapshot(), _in.ReadBoolean(), MaybeVector(), MaybeVector());
        }

        private Snapshot Snapshot()
        {
            Pose pose = Pose();
            return new Snapshot
            {
                Position = pose.Position,
                Orientation = pose.Orientation,
                OwnOrientation = _in.ReadBoolean() ? Orientation() : (Orientation?)null,
                Velocity = MaybeVector(),
                AngularVelocity = MaybeVector(),
                Force = MaybeVector(),
                Torque = MaybeVector(),
                Mass = _in.ReadBoolean() ? _in.ReadDouble() : (double?)null,
                Inertia = MaybeMatrix(),
            };
        }

        private Pose Pose() => new Pose(Vector(), Orientation());

        private Vector? MaybeVector() => _in.ReadBoolean() ? Vector() : (Vector?)null;

        private Matrix? MaybeMatrix() => _in.ReadBoolean() ? new Matrix(Vector(), Vector(), Vector()) : (Matrix?)null;

        private Vector Vector() => new Vector(_in.ReadDouble(), _in.ReadDouble(), _in.ReadDouble());

        private Orientation Orientation() => new Orientation(Vector(), _in.ReadDouble());
    }
}
