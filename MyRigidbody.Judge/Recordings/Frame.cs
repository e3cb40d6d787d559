namespace RigidBodyDynamics.Judging
{
    /// <summary>The state of a script and its object at one moment; null where the script has no such variable. SI units, world axes.</summary>
    public sealed class Snapshot
    {
        /// <summary>transform.position.</summary>
        public Vector Position { get; internal set; }

        /// <summary>transform.rotation.</summary>
        public Orientation Orientation { get; internal set; }

        /// <summary>The script's own quaternion, of any length; null where it has none.</summary>
        public Orientation? OwnOrientation { get; internal set; }

        public Vector? Velocity { get; internal set; }

        public Vector? AngularVelocity { get; internal set; }

        public Vector? Force { get; internal set; }

        public Vector? Torque { get; internal set; }

        public double? Mass { get; internal set; }

        /// <summary>I_ref, or its inverse where the script stores that.</summary>
        public Matrix? Inertia { get; internal set; }
    }

    /// <summary>One frame: the script's state before it, its input, and its state after it.</summary>
    public sealed class Frame
    {
        internal Frame(FrameInput input, Snapshot before, Snapshot after, bool isSetAnew, Vector? force, Vector? torque)
        {
            Input = input;
            Before = before;
            After = after;
            IsSetAnew = isSetAnew;
            GivenForce = force;
            GivenTorque = torque;
        }

        public FrameInput Input { get; }

        public Snapshot Before { get; }

        public Snapshot After { get; }

        /// <summary>True if the experiment wrote to the script's variables just before this frame.</summary>
        public bool IsSetAnew { get; }

        /// <summary>The force of the experiment in place of the keys' during the frame; null: the keys' own.</summary>
        public Vector? GivenForce { get; }

        /// <summary>As <see cref="GivenForce"/>.</summary>
        public Vector? GivenTorque { get; }
    }
}
