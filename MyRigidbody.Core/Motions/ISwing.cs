namespace RigidBodyDynamics
{
    /// <summary>May be implemented by an effect under which a body oscillates: explain then names the step lengths for which it stays bounded.</summary>
    public interface ISwing
    {
        /// <summary>
        /// The step length, s, below which the oscillation stays bounded for an integrator that alternates pushes and motion (Splitting,
        /// Exact, LabEuler): 2/ω, ω the angular frequency.
        /// </summary>
        double LongestStableStep(MassProperties mass);
    }
}
