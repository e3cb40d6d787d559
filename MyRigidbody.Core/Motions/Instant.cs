namespace RigidBodyDynamics
{
    /// <summary>A time, and the number of the step that contains it.</summary>
    public readonly struct Instant
    {
        /// <summary>Number of the step, from 0.</summary>
        public readonly long Step;

        /// <summary>Time since the start of the scene, s.</summary>
        public readonly double Time;

        /// <summary>
        /// True while time is held: a composition of higher order lets it pass during the drift alone, so a push that
        /// depends on it acts with its value at this instant, for any duration.
        /// </summary>
        public readonly bool IsHeld;

        /// <summary>True where a sum applies its pushes from the last to the first, the mirror image of the other order.</summary>
        public readonly bool IsReversed;

        /// <summary>A time within a step.</summary>
        public Instant(long step, double time, bool isHeld = false, bool isReversed = false)
        {
            Step = step;
            Time = time;
            IsHeld = isHeld;
            IsReversed = isReversed;
        }

        /// <summary>The same time, with the pushes of a sum from the last to the first.</summary>
        public Instant Reversed => new Instant(Step, Time, IsHeld, true);

        /// <summary>A later time within the same step.</summary>
        public Instant Later(double duration) => new Instant(Step, Time + duration, IsHeld, IsReversed);
    }
}
