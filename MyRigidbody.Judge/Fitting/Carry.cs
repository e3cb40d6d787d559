using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Step 3 or 4 through all frames, by the reading that fits most of them.</summary>
    internal sealed class Carry
    {
        /// <summary>A rotation by more than half a revolution in a frame, in radians, is ambiguous.</summary>
        private const double MostTurned = 3;

        private readonly Reading _reading;
        private readonly string _form;

        private Carry(Reading reading, string form, IReadOnlyList<int> missed, int seen)
        {
            _reading = reading;
            _form = form;
            Missed = missed;
            Seen = seen;
        }

        /// <summary>The frames that no reading explains.</summary>
        public IReadOnlyList<int> Missed { get; }

        /// <summary>The number of frames with enough motion to be judged.</summary>
        public int Seen { get; }

        public bool IsRight => Missed.Count == 0;

        /// <summary>The pose moves by a velocity that has been damped already.</summary>
        public bool IsDampedBefore => _reading.Code == Reading.DampedBefore;

        /// <summary>What an instructor has to decide: a form or a reading that is neither the sheet's nor a mistake; null for none.</summary>
        public string Code => !IsRight ? null : _form ?? (IsDampedBefore ? null : _reading.Code);

        /// <summary>Step 3: x ← x + Δt v.</summary>
        public static Carry OfPosition(Chain chain) => Best(chain, null, o => o.Moved, (o, d) =>
            4e-7 * (o.Before.Position.Length + o.After.Position.Length) + 1e-5 * d.Length + 1e-7, 1e6);

        /// <summary>Step 4: by the formula; else by the exact rotation, or by Euler angles of a small rotation, if one of them is right.</summary>
        public static Carry OfOrientation(Chain chain)
        {
            Carry formula = Best(chain, null, o => Turns.FirstOrder(o.Turn), Tolerance, MostTurned);
            if (formula.IsRight)
                return formula;
            return Best(chain, "exact-turn", o => Turns.Exact(o.Turn), Tolerance, MostTurned, 1)
                ?? Best(chain, "euler-turn", o => Turns.Euler(o.Turn), Tolerance, MostTurned, 1)
                ?? formula;
        }

        private static double Tolerance(Observation o, Vector turn) => Turns.Tolerance(turn);

        /// <summary>The reading that misses the fewest frames; null if all miss at least <paramref name="tooMany"/>.</summary>
        private static Carry Best(
            Chain chain, string form, Func<Observation, Vector> carried, Func<Observation, Vector, double> tolerance, double longest, int tooMany = int.MaxValue)
        {
            Carry best = null;
            foreach (Reading reading in Reading.Of(chain))
            {
                best = With(reading, form, chain, carried, tolerance, longest, best?.Missed.Count ?? tooMany) ?? best;
                if (best != null && best.IsRight)
                    break;
            }

            return best;
        }

        private static Carry With(
            Reading reading, string form, Chain chain, Func<Observation, Vector> carried, Func<Observation, Vector, double> tolerance, double longest, int tooMany)
        {
            List<int> missed = new List<int>();
            int seen = 0;
            for (int i = 0; i < chain.Links.Length; i++)
            {
                Observation o = chain.Links[i].At;
                double h = chain.Step.At(o);
                Vector expected = h * reading.Velocity(chain, i);
                double length = expected.Length;
                if (!expected.IsFinite || length > longest || !o.Before.Position.IsFinite || !o.Before.Orientation.IsFinite)
                    continue;
                seen += length > 1e-3 ? 1 : 0;
                // where a velocity almost vanishes, the factor of step 5 is not visible
                double unseen = 0.03 * Math.Min(length, 2e-3 * h);
                if (!((carried(o) - expected).Length <= tolerance(o, expected) + unseen))
                    missed.Add(i);
                if (missed.Count >= tooMany)
                    return null;
            }

            return new Carry(reading, form, missed, seen);
        }
    }
}
