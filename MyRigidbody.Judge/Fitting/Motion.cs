using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One velocity through all frames, with the gain read in one way.</summary>
    internal sealed class Links
    {
        public Links(Source source, IReadOnlyList<Link> all, string code = null)
        {
            Code = code;
            Source = source;
            All = all;
        }

        public Source Source { get; }

        public IReadOnlyList<Link> All { get; }

        /// <summary>What an instructor decides about the gain; null: it is the sheet's.</summary>
        public string Code { get; }
    }

    /// <summary>All frames, and every way in which their gains may rightly be read: where the force comes from, which R and which I_ref.</summary>
    internal sealed class Motion
    {
        private static readonly Source[] Sources = { Source.Variable, Source.Demanded, Source.Keys, Source.Earlier };

        public Motion(IReadOnlyList<Observation> frames)
        {
            Frames = frames;
            Observation[] moving = frames.Where(o => o.Before.Velocity.HasValue && o.After.Velocity.HasValue).ToArray();
            Velocity = Sources.Select(source => new Lazy<Links>(() => new Links(source, moving
                .Select(o => new Link(o, o.Before.Velocity.Value, o.After.Velocity.Value, (1 / o.Mass) * o.Force(source))).ToArray()))).ToArray();
            Observation[] turning = frames.Where(o => o.Before.AngularVelocity.HasValue && o.After.AngularVelocity.HasValue).ToArray();
            AngularVelocity = (
                from reference in Inertias.References
                from rotation in Inertias.Rotations
                let inverses = new Lazy<Matrix[]>(() => Array.ConvertAll(turning, o => Inverse(o, reference, rotation)))
                from source in Sources
                select new Lazy<Links>(() => new Links(source, turning
                    .Select((o, i) => new Link(o, o.Before.AngularVelocity.Value, o.After.AngularVelocity.Value, Acceleration(o, inverses.Value[i], source))).ToArray())))
                .Concat(Sources.Take(2).Select(source => new Lazy<Links>(() => new Links(source, turning
                    .Select(o => new Link(o, o.Before.AngularVelocity.Value, o.After.AngularVelocity.Value, WithGyroscopicTerm(o, source))).ToArray(), "gyroscopic-term")))).ToArray();
        }

        public IReadOnlyList<Observation> Frames { get; }

        /// <summary>v with F/m, the likeliest source first.</summary>
        public IReadOnlyList<Lazy<Links>> Velocity { get; }

        /// <summary>ω with I⁻¹τ.</summary>
        public IReadOnlyList<Lazy<Links>> AngularVelocity { get; }

        /// <summary>(R I_ref Rᵀ)⁻¹; zero where no source has a torque for it.</summary>
        private static Matrix Inverse(Observation o, Func<Observation, Matrix> reference, Func<Observation, Matrix> rotation)
        {
            if (!o.IsTurnKnown || Sources.All(source => o.Torque(source).Equals(Vector.Zero)))
                return default(Matrix);
            Matrix r = rotation(o);
            return (r * reference(o) * r.Transpose).Inverse;
        }

        private static Vector Acceleration(Observation o, Matrix inverse, Source source)
        {
            Vector torque = o.Torque(source);
            if (!o.IsTurnKnown)
                return new Vector(double.NaN, double.NaN, double.NaN);
            return torque.Equals(Vector.Zero) ? torque : inverse * torque;
        }

        /// <summary>I⁻¹ (τ − ω × I ω), which is what a body does and the sheet leaves out.</summary>
        private static Vector WithGyroscopicTerm(Observation o, Source source)
        {
            Matrix r = Inertias.Rotations[0](o), i = r * Inertias.Kept(o) * r.Transpose;
            Vector w = o.Before.AngularVelocity.Value;
            return i.Inverse * (o.Torque(source) - Vector.Cross(w, i * w));
        }
    }
}
