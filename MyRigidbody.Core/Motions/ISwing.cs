namespace RigidBodyDynamics
{
    /// <summary>What an effect may implement besides if a body swings by it: explain then says in which steps it stays bounded.</summary>
    public interface ISwing
    {
        /// <summary>
        /// The step, s, below which the swing stays bounded by a rule that pushes and moves in turn (Splitting, Exact, LabEuler):
        /// 2/ω, ω the angular frequency.
        /// </summary>
        double LongestStableStep(MassProperties mass);
    }
}
