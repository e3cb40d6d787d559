namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect that a body coasts with: gravity, a constant force and damping change a velocity at a rate that depends on nothing
    /// but that velocity, so all of them together have one closed form, <see cref="Coasting"/>.
    /// </summary>
    public interface ICoast : IEffect
    {
        /// <summary>Adds this effect's share in the motion of a body of this mass.</summary>
        void AddTo(ref Coasting coasting, MassProperties mass);
    }
}
