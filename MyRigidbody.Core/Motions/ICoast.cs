namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect that a body coasts with: gravity and damping change a velocity at a rate that depends on nothing but
    /// that velocity, so all of them together have one closed form, <see cref="Coasting"/>.
    /// </summary>
    public interface ICoast : IEffect
    {
        /// <summary>Adds this effect's share.</summary>
        void AddTo(ref Coasting coasting);
    }
}
