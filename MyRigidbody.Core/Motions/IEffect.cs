namespace RigidBodyDynamics
{
    /// <summary>What acts on a body: an <see cref="IPush"/> or an <see cref="ICoast"/>. Its <c>ToString</c> is how explain calls it.</summary>
    public interface IEffect
    {
        /// <summary>What it is, what it does to a body and what it needs to know: what is not said here may be left out.</summary>
        EffectTraits Traits { get; }
    }
}
