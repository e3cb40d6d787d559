namespace RigidBodyDynamics
{
    /// <summary>How many steps of a simulation are done, for those of its bodies that look only when they are looked at.</summary>
    internal sealed class Clock
    {
        public long Step;
    }
}
