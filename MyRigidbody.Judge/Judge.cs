using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>
    /// The decision: which of the five steps are as the sheet has them. Every step is fitted frame by frame from the script's own state
    /// before it. What no frame shows alone, the time step and the order of damping, is tried in every way; the way that leaves the
    /// fewest steps off is told.
    /// </summary>
    public static class Judge
    {
        public static Verdict Decide(Recording recording)
        {
            IReadOnlyList<Observation> frames = Observation.Of(recording);
            // what a script means, its time step and where it takes the gains from, is seen in a part of the frames; what it does is then looked for in all
            Motion part = new Motion(frames.Where(o => o.IsVaried || o.Index % 10 == 0));
            Explanation best = Best(TimeStep.Candidates(Slopes(frames)).Select(step => new Explanation(part, step)));
            return new Conclusion(frames, best.In(new Motion(frames))).Verdict();
        }

        /// <summary>The first that leaves nothing off; else the first of those that leave the least.</summary>
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

        /// <summary>What stands in the place of Δt in each step at 50 frames a second, as the median frame has it.</summary>
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
