using System.Collections.Generic;
using System.IO;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One experiment, played.</summary>
    public sealed class Run
    {
        private Matrix? _inertiaOfMesh;

        internal Run(string name, Setting setting, Matrix? inertiaAtStart, IReadOnlyList<Frame> frames)
        {
            Name = name;
            Setting = setting;
            InertiaAtStart = inertiaAtStart;
            Frames = frames;
        }

        public string Name { get; }

        public Setting Setting { get; }

        /// <summary>I_ref after Start, before the experiment replaced it.</summary>
        public Matrix? InertiaAtStart { get; }

        public IReadOnlyList<Frame> Frames { get; }

        /// <summary>Σ m (r·r 1 − r rᵀ) of the mesh for a mass of 1 kg; cached, because every frame needs it.</summary>
        internal Matrix InertiaOfMesh => _inertiaOfMesh ?? (_inertiaOfMesh = Matrix.InertiaOf(Setting.Vertices)).Value;

        internal bool IsVaried => Frames.Count > 0 && Frames[0].IsSetAnew;
    }

    /// <summary>All that was recorded of a script; plain numbers, which can be sent from one process to another.</summary>
    public sealed class Recording
    {
        internal Recording(IReadOnlyList<Run> runs, IReadOnlyDictionary<string, string> variables)
        {
            Runs = runs;
            Variables = variables;
        }

        /// <summary>The first is the lab's own scene without changes; the second is a rotated box.</summary>
        public IReadOnlyList<Run> Runs { get; }

        /// <summary>
        /// The name of the script's variable for each role: Force, Torque, Velocity, AngularVelocity, Position, Orientation, Mass, Inertia.
        /// A role without a variable is absent.
        /// </summary>
        public IReadOnlyDictionary<string, string> Variables { get; }

        public static Recording ReadFrom(Stream stream) => new RecordingReader(stream).Recording();

        public void WriteTo(Stream stream) => new RecordingWriter(stream).Recording(this);
    }
}
