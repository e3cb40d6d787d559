namespace RigidBodyDynamics
{
    /// <summary>Anything that acts on a body: an <see cref="IPush"/> or an <see cref="ICoast"/>. Its <c>ToString</c> is its name in explain.</summary>
    public interface IEffect
    {
        /// <summary>The kind of effect, what it does to a body and what it reads: what is not declared may be omitted from the motion.</summary>
        EffectTraits Traits { get; }
    }
}
