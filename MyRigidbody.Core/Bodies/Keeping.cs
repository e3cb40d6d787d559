namespace RigidBodyDynamics
{
    /// <summary>What goes on where the mass of a body changes. Its frame stays in its place.</summary>
    public enum Keeping
    {
        /// <summary>Every point of the body keeps its velocity: what comes moves with it, what leaves does so at rest to it (fuel).</summary>
        Velocity,

        /// <summary>Momentum, and angular momentum about the centre of mass: what comes had none, what moved did so within the body.</summary>
        Momentum,
    }
}
