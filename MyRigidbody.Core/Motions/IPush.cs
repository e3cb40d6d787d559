using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect that pushes or turns a body. To write one of your own, write a struct with these three members; to
    /// use it, <c>body.With(new MyEffect(...))</c>.
    /// </summary>
    /// <remarks>
    /// Both questions are asked of a struct known at compile time, so an effect costs what it computes and one that
    /// is not in the scene costs nothing. Neither may change the effect or allocate.
    /// </remarks>
    public interface IPush : IEffect
    {
        /// <summary>Adds the force and torque at this instant. Asked by integrators that evaluate.</summary>
        void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench);

        /// <summary>
        /// Adds the impulse this effect alone gives in the time that follows, the body held in its place: its exact
        /// flow. Asked by integrators that compose; the duration may be negative. What depends on neither time nor
        /// velocity gives duration × At, and so does what depends on time while <see cref="Instant.IsHeld"/>. The impulse
        /// comes in with what other pushes gave before in the same time: the body now moves as
        /// <see cref="Wrench.AppliedTo"/> says. What reads a velocity and has no exact flow may give one that comes back: for −h
        /// what it took for h. EffectCheck tries all this.
        /// </summary>
        void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse);
    }

    /// <summary>What an effect is, what it does and what it reads.</summary>
    [Flags]
    public enum EffectTraits
    {
        /// <summary>Nothing.</summary>
        None = 0,

        /// <summary>Has a force.</summary>
        Moves = 1,

        /// <summary>Has a torque.</summary>
        Turns = 2,

        /// <summary>Depends on the time or the number of the step.</summary>
        ReadsTime = 4,

        /// <summary>Depends on the position.</summary>
        ReadsPosition = 8,

        /// <summary>Depends on the orientation.</summary>
        ReadsOrientation = 16,

        /// <summary>Depends on the velocity.</summary>
        ReadsVelocity = 32,

        /// <summary>Depends on the angular velocity.</summary>
        ReadsAngularVelocity = 64,

        /// <summary>
        /// Its force and torque are the slope of a potential energy of position and orientation: around a closed way it does no
        /// work. Reads neither time nor a velocity.
        /// </summary>
        HasPotential = 128,

        /// <summary>Is gravity: of a planet, of a field, about a pivot.</summary>
        IsGravity = 256,

        /// <summary>Is damping: takes the same share of a fast velocity and of a slow one.</summary>
        IsDamping = 512,

        /// <summary>Is drag: what a medium does to a body that moves through it, wind too.</summary>
        IsDrag = 1024,

        /// <summary>Acts once at the end of each step, whatever its length: what it does in a second depends on the number of steps.</summary>
        OncePerStep = 2048,
    }

    internal static class TraitsOfSums
    {
        /// <summary>A sum does and reads what any of its parts does and reads; it has a potential if every part has one.</summary>
        public static EffectTraits And(this EffectTraits a, EffectTraits b) => (a & b) | ((a | b) & ~EffectTraits.HasPotential);
    }
}
