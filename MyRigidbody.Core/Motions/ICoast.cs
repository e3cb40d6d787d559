namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect with a closed form: gravity, a constant force and damping change a velocity at a rate that depends only on that
    /// velocity, so all of them together have one closed form, <see cref="Coasting"/>.
    /// </summary>
    public interface ICoast : IEffect
    {
        /// <summary>Adds the contribution of this effect for a body of this mass.</summary>
        void AddTo(ref Coasting coasting, MassProperties mass);
    }
}
