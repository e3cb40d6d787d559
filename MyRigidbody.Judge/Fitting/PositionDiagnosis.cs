using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>How a script moves instead of x ← x + Δt v.</summary>
    internal static class PositionDiagnosis
    {
        private const string Expected = "Δx = Δt v";

        private static readonly CarryShape[] Shapes =
        {
            new CarryShape(null, "v", o => o.Moved),
            new CarryShape("x-assigned", "v − x", o => o.After.Position),
            new CarryShape("x-in-body-axes", "R v", o => Rotation(o).Transpose * o.Moved),
            new CarryShape("x-in-body-axes", "Rᵀ v", o => Rotation(o) * o.Moved),
        };

        public static IEnumerable<Finding> Findings(Explanation explanation)
        {
            CarryDiagnosis d = new CarryDiagnosis(explanation.Velocity, Shapes,
                (o, x) => 8e-7 * (o.Before.Position.Length + o.After.Position.Length) + 2e-5 * x.Length + 1e-7);
            if (explanation.Velocity.Links.Any(l => l.Before.IsFinite && l.After.IsFinite && l.At.Before.Position.IsFinite && !l.At.After.Position.IsFinite))
                return One("x-not-a-number", "NaN");
            if (d.Share < 0.9)
                return One(Acceleration(explanation) ?? Other(explanation), Example(explanation));
            string factor = d.Factor(explanation.Step), found = $"{Text.Of(d.Gains.Median)} · {d.Shape.Formula}";
            List<Finding> findings = new List<Finding>();
            if (d.Shape.Code != null)
                findings.Add(Words.Finding(Step.Position, d.Shape.Code, Expected, found));
            if (factor != null)
                findings.Add(Words.Finding(Step.Position, Code(factor), Expected, found));
            return findings.Count > 0 ? findings : One(Other(explanation), found).ToList();
        }

        private static string Code(string factor)
        {
            if (factor == "time-for-dt" || factor == "two-time-steps")
                return factor;
            return factor.Contains("degrees") ? "x-factor" : "x-" + factor;
        }

        private static Finding[] One(string code, string found) => new[] { Words.Finding(Step.Position, code, Expected, found) };

        /// <summary>Δx = Δt v + r F/m with another r than in the two readings.</summary>
        private static string Acceleration(Explanation explanation)
        {
            Chain chain = explanation.Velocity;
            int seen = 0, fitted = 0;
            for (int i = 0; i < chain.Links.Length; i++)
            {
                Link link = chain.Links[i];
                if (link.Gain.Length < 0.1 || !link.Before.IsFinite || !link.At.Moved.IsFinite)
                    continue;
                Coefficients two = Coefficients.Of(link.At.Moved, link.Before, link.Gain);
                if (!(two.Spread > 0.05))
                    continue;
                seen++;
                double noise = 8e-7 * (link.At.Before.Position.Length + link.At.After.Position.Length) + 1e-6;
                fitted += two.Residual < noise && System.Math.Abs(two.Second) > 1e-5 && System.Math.Abs(two.First / explanation.Step.At(link.At) - 1) < 0.01 ? 1 : 0;
            }

            return seen > 10 && fitted > 0.9 * seen ? "x-acceleration" : null;
        }

        private static string Other(Explanation explanation)
        {
            IReadOnlyList<int> missed = explanation.Position.Missed;
            if (missed.All(i => explanation.Velocity.Links[i].At.Index == 0))
                return "starts-elsewhere";
            return missed.Count < explanation.Velocity.Links.Length / 50 ? "x-sometimes" : "x-formula";
        }

        private static string Example(Explanation explanation) => Text.Of(explanation.Velocity.Links[explanation.Position.Missed[0]].At.Moved);

        private static Matrix Rotation(Observation o) => Matrix.Rotation(o.Before.Orientation.Normalized);
    }
}
