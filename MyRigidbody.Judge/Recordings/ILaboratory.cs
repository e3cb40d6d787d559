using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The sheet's keys.</summary>
    [Flags]
    public enum Keys
    {
        None = 0,
        LeftArrow = 1,
        RightArrow = 2,
        UpArrow = 4,
        DownArrow = 8,
        R = 16,
    }

    /// <summary>An engine in which a script can be played: the stand-in, or a window of the editor.</summary>
    public interface ILaboratory
    {
        /// <summary>The pose of the object in the engine.</summary>
        Pose Pose { get; set; }

        /// <summary>Called when the script reads one of the five keys, before the answer. An engine that cannot do so ignores it.</summary>
        Action<Keys> KeyAsked { set; }

        /// <summary>Creates an object with a new script, which is returned; neither Awake nor Start has run.</summary>
        object Begin(Setting setting);

        /// <summary>Runs Awake, OnEnable and Start of the script.</summary>
        void Start();

        /// <summary>Plays one frame: FixedUpdate once, Update once, LateUpdate once.</summary>
        void Frame(FrameInput input);
    }

    /// <summary>The object of the script.</summary>
    public sealed class Setting
    {
        public Setting(Pose pose, Vector scale, IReadOnlyList<Vector> vertices)
        {
            Pose = pose;
            Scale = scale;
            Vertices = vertices;
        }

        public Pose Pose { get; }

        /// <summary>transform.localScale.</summary>
        public Vector Scale { get; }

        /// <summary>The vertices of the mesh, not scaled; 24 as for Unity's cube.</summary>
        public IReadOnlyList<Vector> Vertices { get; }
    }

    /// <summary>transform.position and transform.rotation.</summary>
    public sealed class Pose
    {
        public Pose(Vector position, Orientation orientation)
        {
            Position = position;
            Orientation = orientation;
        }

        public Vector Position { get; }

        public Orientation Orientation { get; }
    }

    /// <summary>The engine's input of one frame; times in seconds.</summary>
    public struct FrameInput
    {
        public FrameInput(int number, double time, double delta, Keys held)
        {
            Number = number;
            Time = time;
            Delta = delta;
            Held = held;
        }

        /// <summary>Length of a fixed step, Unity's own.</summary>
        public const double FixedDelta = 0.02;

        /// <summary>Time.frameCount.</summary>
        public int Number { get; }

        /// <summary>Time.time and Time.fixedTime.</summary>
        public double Time { get; }

        /// <summary>Time.deltaTime in Update; in FixedUpdate it is <see cref="FixedDelta"/>.</summary>
        public double Delta { get; }

        public Keys Held { get; }
    }
}
