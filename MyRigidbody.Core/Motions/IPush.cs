using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A push: an effect with a force or torque. To write one of your own, write a struct with these three members; to
    /// use it, <c>body.With(new MyEffect(...))</c>.
    /// </summary>
    /// <remarks>
    /// Both methods are called on a struct type known at compile time, so an effect costs only its own arithmetic, and one that
    /// is not in the scene costs nothing. Neither method may change the effect or allocate.
    /// </remarks>
    public interface IPush : IEffect
    {
        /// <summary>Adds the force and torque at this instant. Called by integrators that evaluate.</summary>
        void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench);

        /// <summary>
        /// Adds the impulse that this effect alone gives in the following time, while the pose of the body is fixed: its exact
        /// flow. Called by integrators that compose; the duration may be negative. A push that depends on neither time nor
        /// velocity gives duration × At, and so does one that depends on time while <see cref="Instant.IsHeld"/>. The impulse already
        /// contains what other pushes gave in the same time: the body now moves as <see cref="Wrench.AppliedTo"/> says. A push that
        /// reads a velocity and has no exact flow may give a reversible one: for −h the opposite of what it gave for h. EffectCheck
        /// tests all this.
        /// </summary>
        void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse);
    }

    /// <summary>The kind of an effect, what it does and what it reads.</summary>
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
        /// Its force and torque are the gradient of a potential energy of position and orientation: along a closed path it does no
        /// work. Reads neither time nor a velocity.
        /// </summary>
        HasPotential = 128,

        /// <summary>Is gravity: of a planet, of a field, about a pivot.</summary>
        IsGravity = 256,

        /// <summary>Is damping: multiplies any velocity by the same factor.</summary>
        IsDamping = 512,

        /// <summary>Is drag: the force of a medium on a body that moves through it, including wind.</summary>
        IsDrag = 1024,

        /// <summary>Acts once at the end of each step, whatever its length: the effect over a second depends on the number of steps.</summary>
        OncePerStep = 2048,
    }

    internal static class TraitsOfSums
    {
        /// <summary>A sum does and reads what any of its parts does and reads; it has a potential if every part has one.</summary>
        public static EffectTraits And(this EffectTraits a, EffectTraits b) => (a & b) | ((a | b) & ~EffectTraits.HasPotential);
    }
}
