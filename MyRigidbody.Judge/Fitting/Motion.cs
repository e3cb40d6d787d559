using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>All frames, and every way in which their gains may rightly be read: where the force comes from, which R and which I_ref.</summary>
    internal sealed class Motion
    {
        private static readonly Source[] Sources = { Source.Variable, Source.Demanded, Source.Keys, Source.Earlier };

        public Motion(IReadOnlyList<Observation> frames)
        {
            Frames = frames;
            Observation[] moving = frames.Where(o => o.Before.Velocity.HasValue && o.After.Velocity.HasValue).ToArray();
            Velocity = Sources.Select(source => new Lazy<Link[]>(() => moving
                .Select(o => new Link(o, o.Before.Velocity.Value, o.After.Velocity.Value, (1 / o.Mass) * o.Force(source))).ToArray())).ToArray();
            Observation[] turning = frames.Where(o => o.Before.AngularVelocity.HasValue && o.After.AngularVelocity.HasValue).ToArray();
            AngularVelocity = (
                from reference in Inertias.References
                from rotation in Inertias.Rotations
                from source in Sources
                select new Lazy<Link[]>(() => turning
                    .Select(o => new Link(o, o.Before.AngularVelocity.Value, o.After.AngularVelocity.Value, Acceleration(o, reference, rotation, source))).ToArray())).ToArray();
        }

        public IReadOnlyList<Observation> Frames { get; }

        /// <summary>v with F/m, the likeliest source first.</summary>
        public IReadOnlyList<Lazy<Link[]>> Velocity { get; }

        /// <summary>ω with I⁻¹τ.</summary>
        public IReadOnlyList<Lazy<Link[]>> AngularVelocity { get; }

        private static Vector Acceleration(Observation o, Func<Observation, Matrix> reference, Func<Observation, Matrix> rotation, Source source)
        {
            Vector torque = o.Torque(source);
            if (torque.Equals(Vector.Zero))
                return torque;
            Matrix r = rotation(o);
            return (r * reference(o) * r.Transpose).Inverse * torque;
        }
    }
}
