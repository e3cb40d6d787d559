namespace RigidBodyDynamics
{
    /// <summary>When something acts: the step it belongs to, and the time.</summary>
    public readonly struct Instant
    {
        /// <summary>Number of the step, from 0.</summary>
        public readonly long Step;

        /// <summary>Time since the start of the scene, s.</summary>
        public readonly double Time;

        /// <summary>A time within a step.</summary>
        public Instant(long step, double time)
        {
            Step = step;
            Time = time;
        }

        /// <summary>A later time within the same step.</summary>
        public Instant Later(double duration) => new Instant(Step, Time + duration);
    }
}
