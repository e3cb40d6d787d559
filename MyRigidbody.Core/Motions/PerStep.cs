using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A force and a torque for every step, as a recording has them. Zero after the last.</summary>
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

        public PushTraits Traits =>
            (_force.Length > 0 ? PushTraits.Moves | PushTraits.ReadsTime : PushTraits.None)
            | (_torque.Length > 0 ? PushTraits.Turns | PushTraits.ReadsTime : PushTraits.None);

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            if (now.Step < _force.Length)
                impulse.Force += duration * _force[now.Step];

            if (now.Step < _torque.Length)
                impulse.Torque += duration * _torque[now.Step];
        }

        /// <summary>In words.</summary>
        public override string ToString() => "a force for each of " + _force.Length + " steps, a torque for each of " + _torque.Length;

        private static Vector3d[] Copy(IReadOnlyList<Vector3d> values, string name)
        {
            Vector3d[] copy = new Vector3d[Guard.NotNull(values, name).Count];
            for (int i = 0; i < copy.Length; i++)
                copy[i] = Guard.Finite(values[i], name, i);

            return copy;
        }
    }
}
