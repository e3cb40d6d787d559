namespace RigidBodyDynamics
{
    /// <summary>What is conserved where the mass of a body changes. Its frame stays in its place.</summary>
    public enum Keeping
    {
        /// <summary>Every point of the body keeps its velocity: mass arrives or leaves with the velocity of the body at that point (fuel).</summary>
        Velocity,

        /// <summary>Momentum, and angular momentum about the centre of mass: arriving mass has none, and mass that moves does so within the body.</summary>
        Momentum,
    }
}
