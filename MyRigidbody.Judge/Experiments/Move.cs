namespace RigidBodyDynamics.Judging
{
    /// <summary>What an experiment does in one frame; null leaves it to the script.</summary>
    internal sealed class Move
    {
        public double Delta { get; set; } = FrameInput.FixedDelta;

        public Keys Held { get; set; }

        /// <summary>The state that the script gets before the frame.</summary>
        public State State { get; set; }

        /// <summary>The force in place of that of the keys.</summary>
        public Vector? Force { get; set; }

        public Vector? Torque { get; set; }
    }

    /// <summary>A state of motion.</summary>
    internal sealed class State
    {
        public State(Vector position, Orientation orientation, Vector velocity, Vector angularVelocity)
        {
            Position = position;
            Orientation = orientation;
            Velocity = velocity;
            AngularVelocity = angularVelocity;
        }

        public Vector Position { get; }

        public Orientation Orientation { get; }

        public Vector Velocity { get; }

        public Vector AngularVelocity { get; }
    }
}
