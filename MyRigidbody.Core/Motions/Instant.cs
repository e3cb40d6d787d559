namespace RigidBodyDynamics
{
    /// <summary>When something acts: the step it belongs to, and the time.</summary>
    public readonly struct Instant
    {
        /// <summary>Number of the step, from 0.</summary>
        public readonly long Step;

        /// <summary>Time since the start of the scene, s.</summary>
        public readonly double Time;

        /// <summary>
        /// True while time stands still: a composition of higher order lets it pass with the drift alone, so that what
        /// depends on it acts with its value at this instant, however long.
        /// </summary>
        public readonly bool IsHeld;

        /// <summary>True where a sum goes through its pushes from the last to the first, the mirror image of the way before.</summary>
        public readonly bool IsReversed;

        /// <summary>A time within a step.</summary>
        public Instant(long step, double time, bool isHeld = false, bool isReversed = false)
        {
            Step = step;
            Time = time;
            IsHeld = isHeld;
            IsReversed = isReversed;
        }

        /// <summary>The same time, with sums gone through from the last to the first.</summary>
        public Instant Reversed => new Instant(Step, Time, IsHeld, true);

        /// <summary>A later time within the same step.</summary>
        public Instant Later(double duration) => new Instant(Step, Time + duration, IsHeld, IsReversed);
    }
}
