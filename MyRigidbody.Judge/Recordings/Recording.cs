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

        /// <summary>I_ref as Start left it, before the experiment put another in its place.</summary>
        public Matrix? InertiaAtStart { get; }

        public IReadOnlyList<Frame> Frames { get; }

        /// <summary>Σ m (r·r 1 − r rᵀ) of the mesh for a mass of 1 kg; every frame asks for it.</summary>
        internal Matrix InertiaOfMesh => _inertiaOfMesh ?? (_inertiaOfMesh = Matrix.InertiaOf(Setting.Vertices)).Value;

        internal bool IsVaried => Frames.Count > 0 && Frames[0].IsSetAnew;
    }

    /// <summary>All that was seen of a script; plain numbers, which can be sent from one process to another.</summary>
    public sealed class Recording
    {
        internal Recording(IReadOnlyList<Run> runs, IReadOnlyDictionary<string, string> variables)
        {
            Runs = runs;
            Variables = variables;
        }

        /// <summary>The first is the lab's own scene, left to itself; the second is a turned box.</summary>
        public IReadOnlyList<Run> Runs { get; }

        /// <summary>
        /// Which of the script's variables is taken for what: Force, Torque, Velocity, AngularVelocity, Position, Orientation, Mass, Inertia.
        /// What has no variable is not there.
        /// </summary>
        public IReadOnlyDictionary<string, string> Variables { get; }

        public static Recording ReadFrom(Stream stream) => new RecordingReader(stream).Recording();

        public void WriteTo(Stream stream) => new RecordingWriter(stream).Recording(this);
    }
}
