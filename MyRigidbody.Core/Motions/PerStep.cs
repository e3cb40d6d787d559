using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A force and a torque for every step, as in a recording. Zero after the last.</summary>
    public readonly struct PerStep : IPush
    {
        private readonly Vector3d[] _force;
        private readonly Vector3d[] _torque;

        /// <summary>The lists, N and N m, world axes; either may be empty.</summary>
        public PerStep(IReadOnlyList<Vector3d> force, IReadOnlyList<Vector3d> torque)
        {
            _force = Copy(force, nameof(force));
            _torque = Copy(torque, nameof(torque));
        }

        public EffectTraits Traits =>
            (Count(_force) > 0 ? EffectTraits.Moves | EffectTraits.ReadsTime : EffectTraits.None)
            | (Count(_torque) > 0 ? EffectTraits.Turns | EffectTraits.ReadsTime : EffectTraits.None);

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.Step < Count(_force))
                impulse.Force += duration * _force[now.Step];

            if (now.Step < Count(_torque))
                impulse.Torque += duration * _torque[now.Step];
        }

        /// <summary>The effect in words, for messages and explain.</summary>
        public override string ToString() => "a force for each of " + Count(_force) + " steps, a torque for each of " + Count(_torque);

        // default(PerStep) has no lists
        private static int Count(Vector3d[] values) => values == null ? 0 : values.Length;

        private static Vector3d[] Copy(IReadOnlyList<Vector3d> values, string name)
        {
            Vector3d[] copy = new Vector3d[Guard.NotNull(values, name).Count];
            for (int i = 0; i < copy.Length; i++)
                copy[i] = Guard.Finite(values[i], name, i);

            return copy;
        }
    }
}
