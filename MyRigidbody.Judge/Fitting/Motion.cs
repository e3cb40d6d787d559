using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>All frames, and every admissible reading of their gains: the source of the force, which R and which I_ref.</summary>
    internal sealed class Motion
    {
        private static readonly Source[] Sources = { Source.Variable, Source.Demanded, Source.Keys, Source.Earlier };

        public Motion(IEnumerable<Observation> frames)
        {
            Observation[] all = frames.ToArray();
            Velocity = OfForces(new VelocityFrames(all, s => s.Velocity));
            AngularVelocity = OfTorques(new VelocityFrames(all, s => s.AngularVelocity));
        }

        /// <summary>v with F/m.</summary>
        public GainReadings Velocity { get; }

        /// <summary>ω with I⁻¹τ.</summary>
        public GainReadings AngularVelocity { get; }

        private static GainReadings OfForces(VelocityFrames frames)
        {
            Lazy<Vector[]>[] forces = Each(Sources, source => Array.ConvertAll(frames.At, o => o.Force(source)));
            Links[] all = Sources.Select((source, n) => new Links(n, source, frames, i => (1 / frames.At[i].Mass) * forces[n].Value[i])).ToArray();
            return new GainReadings(all, () => Different(forces), frames.GainsNothing);
        }

        private static GainReadings OfTorques(VelocityFrames frames)
        {
            Lazy<Vector[]>[] torques = Each(Sources, source => Array.ConvertAll(frames.At, o => o.Torque(source)));
            // only frames with a torque need I
            Lazy<bool[]> isPushed = new Lazy<bool[]>(() => frames.At.Select((o, i) => o.IsTurnKnown && torques.Any(torque => !torque.Value[i].Equals(Vector.Zero))).ToArray());
            Matrix[] WherePushed(Func<int, Matrix> matrix) => isPushed.Value.Select((isPushedHere, i) => isPushedHere ? matrix(i) : default(Matrix)).ToArray();
            Lazy<Matrix[]>[] references = Each(Inertias.References, reference => WherePushed(i => reference(frames.At[i])));
            Lazy<Matrix[]>[] rotations = Each(Inertias.Rotations, rotation => WherePushed(i => rotation(frames.At[i])));

            List<Links> all = new List<Links>();
            foreach (Lazy<Matrix[]> reference in references)
            {
                foreach (Lazy<Matrix[]> rotation in rotations)
                {
                    Lazy<Matrix[]> inverses = new Lazy<Matrix[]>(() => WherePushed(i => Inverse(reference.Value[i], rotation.Value[i])));
                    for (int n = 0; n < Sources.Length; n++)
                    {
                        Lazy<Vector[]> torque = torques[n];
                        all.Add(new Links(all.Count, Sources[n], frames, i => Acceleration(frames.At[i], inverses.Value[i], torque.Value[i])));
                    }
                }
            }

            int gyroscopic = all.Count;
            for (int n = 0; n < 2; n++)
            {
                Lazy<Vector[]> torque = torques[n];
                all.Add(new Links(all.Count, Sources[n], frames, i => WithGyroscopicTerm(frames.At[i], torque.Value[i]), "gyroscopic-term"));
            }

            IEnumerable<int> DifferentOnes()
            {
                int[] sources = Different(torques), rotated = Different(rotations);
                foreach (int reference in Different(references))
                {
                    foreach (int rotation in rotated)
                    {
                        foreach (int source in sources)
                            yield return (reference * rotations.Length + rotation) * Sources.Length + source;
                    }
                }

                foreach (int source in sources.Where(source => source < 2))
                    yield return gyroscopic + source;
            }

            return new GainReadings(all, DifferentOnes, frames.GainsNothing);
        }

        private static Lazy<T[]>[] Each<TOne, T>(IEnumerable<TOne> all, Func<TOne, T[]> rows) => all.Select(one => new Lazy<T[]>(() => rows(one))).ToArray();

        /// <summary>The rows that differ from all earlier ones.</summary>
        private static int[] Different<T>(Lazy<T[]>[] rows) where T : IEquatable<T> =>
            Enumerable.Range(0, rows.Length).Where(row => !rows.Take(row).Any(earlier => earlier.Value.SequenceEqual(rows[row].Value))).ToArray();

        /// <summary>(R I_ref Rᵀ)⁻¹.</summary>
        private static Matrix Inverse(Matrix reference, Matrix r) => (r * reference * r.Transpose).Inverse;

        private static Vector Acceleration(Observation o, Matrix inverse, Vector torque)
        {
            if (!o.IsTurnKnown)
                return new Vector(double.NaN, double.NaN, double.NaN);
            return torque.Equals(Vector.Zero) ? torque : inverse * torque;
        }

        /// <summary>I⁻¹ (τ − ω × I ω), with the gyroscopic term that the sheet omits.</summary>
        private static Vector WithGyroscopicTerm(Observation o, Vector torque)
        {
            Matrix r = Inertias.Rotations[0](o), i = r * Inertias.Kept(o) * r.Transpose;
            Vector w = o.Before.AngularVelocity.Value;
            return i.Inverse * (torque - Vector.Cross(w, i * w));
        }
    }
}
