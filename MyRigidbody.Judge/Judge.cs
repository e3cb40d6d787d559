using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>
    /// Decides which of the five steps are as on the sheet. Every step is fitted frame by frame from the script's own state before it.
    /// The time step and the order of damping, which no single frame shows, are tried in every combination; the one with the fewest
    /// wrong steps is reported.
    /// </summary>
    public static class Judge
    {
        public static Verdict Decide(Recording recording)
        {
            IReadOnlyList<Observation> frames = Observation.Of(recording);
            // the time step and the source of the gains are found in a part of the frames; the steps are then judged in all of them
            Motion part = new Motion(frames.Where(o => o.IsVaried || o.Index % 10 == 0));
            Explanation best = Best(TimeStep.Candidates(Slopes(frames)).Select(step => new Explanation(part, step)));
            return new Conclusion(frames, best.In(new Motion(frames))).Verdict();
        }

        /// <summary>The first without wrong steps; else the first of those with the fewest.</summary>
        private static Explanation Best(IEnumerable<Explanation> explanations)
        {
            List<Explanation> all = new List<Explanation>();
            foreach (Explanation explanation in explanations)
            {
                if (explanation.LeastCost == 0 && explanation.Cost == 0)
                    return explanation;
                all.Add(explanation);
            }

            Explanation best = all[0];
            foreach (Explanation explanation in all)
            {
                if (explanation.LeastCost < best.Cost && explanation.Cost < best.Cost)
                    best = explanation;
            }

            return best;
        }

        /// <summary>The median factor in place of Δt in each step, at 50 frames a second.</summary>
        private static IEnumerable<double> Slopes(IReadOnlyList<Observation> frames)
        {
            Observation[] usual = frames.Where(o => System.Math.Abs(o.Delta - FrameInput.FixedDelta) < 1e-9 && o.Before.Velocity.HasValue && o.Before.AngularVelocity.HasValue).ToArray();
            yield return Coefficients.Median(usual.Where(o => o.Force(Source.Variable).Length > 1 && o.Before.Velocity.Value.Length > 0.5)
                .Select(o => Coefficients.Of(o.After.Velocity ?? Vector.Zero, o.Before.Velocity.Value, (1 / o.Mass) * o.Force(Source.Variable))).Where(c => c.Spread > 0.5).Select(c => c.Second));
            yield return Coefficients.Median(usual.Where(o => o.Before.Velocity.Value.Length > 0.5 && o.KeyForce.Equals(Vector.Zero)).Select(o => Coefficients.Of(o.Moved, o.Before.Velocity.Value).First));
            yield return Coefficients.Median(usual.Where(o => o.Before.AngularVelocity.Value.Length > 0.5 && o.KeyTorque.Equals(Vector.Zero))
                .Select(o => Coefficients.Of(Turns.FirstOrder(o.Turn), o.Before.AngularVelocity.Value).First));
        }
    }
}
