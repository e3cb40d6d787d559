namespace RigidBodyDynamics
{
    /// <summary>The present step of a simulation, and a flag set by its bodies.</summary>
    internal sealed class Clock
    {
        /// <summary>The starts of the steps. Its own copy, because a step of another length moves all later ones.</summary>
        public readonly TimeSteps Steps;

        /// <summary>The number of steps done.</summary>
        public long Step;

        /// <summary>Length of the last step, s.</summary>
        public double LastLength;

        /// <summary>Set by a body that no longer needs to be stepped.</summary>
        public bool SomeRest;

        public Clock(TimeSteps steps) => Steps = steps.Copy();
    }
}
