namespace RigidBodyDynamics
{
    /// <summary>How far a simulation has come, for those of its bodies that are computed when their state is read.</summary>
    internal sealed class Clock
    {
        /// <summary>When its steps start. It is the simulation's own: a step of another length moves those after it.</summary>
        public readonly TimeSteps Steps;

        /// <summary>How many steps are done.</summary>
        public long Step;

        /// <summary>Length of the last step, s.</summary>
        public double LastLength;

        public Clock(TimeSteps steps) => Steps = steps.Copy();
    }
}
