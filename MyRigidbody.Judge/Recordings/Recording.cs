using System.Collections.Generic;
using System.IO;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One experiment, played.</summary>
    public sealed class Run
    {
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
    }

    /// <summary>All that was seen of a script; plain numbers, which can be sent from one process to another.</summary>
    public sealed class Recording
    {
        internal Recording(IReadOnlyList<Run> runs) => Runs = runs;

        /// <summary>The first is the lab's own scene, left to itself; the second is a turned box.</summary>
        public IReadOnlyList<Run> Runs { get; }

        public static Recording ReadFrom(Stream stream) => new RecordingReader(stream).Recording();

        public void WriteTo(Stream stream) => new RecordingWriter(stream).Recording(this);
    }
}
