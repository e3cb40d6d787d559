namespace RigidBodyDynamics
{
    /// <summary>How far a simulation has come, and what its bodies tell it.</summary>
    internal sealed class Clock
    {
        /// <summary>When its steps start. It is the simulation's own: a step of another length moves those after it.</summary>
        public readonly TimeSteps Steps;

        /// <summary>How many steps are done.</summary>
        public long Step;

        /// <summary>Length of the last step, s.</summary>
        public double LastLength;

        /// <summary>Set by a body that need not be stepped any more.</summary>
        public bool SomeRest;

        public Clock(TimeSteps steps) => Steps = steps.Copy();
    }
}
