using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>How a script rotates instead of q ← q + [0, ½Δt ω] q.</summary>
    internal static class OrientationDiagnosis
    {
        private const string Expected = "Δq = [0, ½Δt ω] q";

        /// <summary>A quaternion of the script's own that is longer than this is not normalised.</summary>
        private const double Longest = 1.05;

        private static readonly CarryShape[] Shapes =
        {
            new CarryShape("q-assigned", "[0, ω] q", o => Pure(o)),
            new CarryShape(null, "[0, ½ω] q", o => Turns.FirstOrder(o.Turn)),
            new CarryShape("order-of-product", "q [0, ½ω]", o => Turns.FirstOrder(o.TurnInBody)),
            new CarryShape("exact-turn", "ω", o => Turns.Exact(o.Turn)),
            new CarryShape("rotate-in-body-axes", "Rᵀ ω", o => Turns.Euler(o.TurnInBody)),
            new CarryShape("order-of-product", "Rᵀ ω", o => Turns.Exact(o.TurnInBody)),
            new CarryShape("euler-turn", "ω", o => Turns.Euler(o.Turn)),
            new CarryShape("euler-angles", "ω", o => AngleDifference(o)),
            new CarryShape("q-left-out", "[0, ½ω]", o => WithoutOrientation(o)),
            new CarryShape("q-assigned", "[1, ½ω]", o => Turns.FirstOrder(o.After.Orientation)),
            new CarryShape("quaternion-arguments", "[½ω, 0]", o => Shifted(o)),
        };

        /// <summary>Frames in which the script's own quaternion is not normalised.</summary>
        public static Observation Lengthening(IReadOnlyList<Observation> frames) =>
            frames.FirstOrDefault(o => o.Before.OwnOrientation.HasValue && Math.Abs(o.After.OwnOrientation.Value.Length - 1) > Longest - 1);

        public static IEnumerable<Finding> Findings(Explanation explanation)
        {
            CarryDiagnosis d = new CarryDiagnosis(explanation.AngularVelocity, Shapes, (o, v) => 2 * Turns.Tolerance(v));
            if (explanation.AngularVelocity.Links.Any(l => l.Before.IsFinite && l.After.IsFinite && l.At.Before.Orientation.IsFinite && !l.At.After.Orientation.IsFinite))
                return One("q-not-a-number", "NaN");
            if (d.Share < 0.9)
                return One(Other(explanation), Example(explanation));
            string factor = d.Factor(explanation.Step), found = $"{Text.Of(d.Gains.Median)} · {d.Shape.Formula}", shape = d.Shape.Code;
            if (factor == "degrees" || factor == "degrees-no-dt")
                return shape == null || shape == "exact-turn" || shape == "euler-turn" ? One("rotate-degrees", found) : One("rotate-degrees", found).Concat(One("rotate-in-body-axes", found));
            // a rotation about the world's axes by another angle: the angle matters more than the formula
            string[] codes = { shape == "exact-turn" || shape == "euler-turn" ? null : shape, Code(factor) };
            Finding[] findings = codes.Where(c => c != null).SelectMany(c => One(c, found)).ToArray();
            return shape == "q-assigned" ? One(shape, found) : findings.Length > 0 ? findings : One(Other(explanation), found);
        }

        private static Finding[] One(string code, string found) => new[] { Words.Finding(Step.Orientation, code, Expected, found) };

        private static string Code(string factor)
        {
            switch (factor)
            {
                case null: return null;
                case "twice": return "half-missing";
                case "half": return "half-twice";
                case "time-for-dt":
                case "two-time-steps": return factor;
                default: return "q-" + factor;
            }
        }

        private static string Other(Explanation explanation) =>
            explanation.Orientation.Missed.Count < explanation.AngularVelocity.Links.Length / 50 ? "q-sometimes" : "q-formula";

        private static string Example(Explanation explanation) =>
            Text.Of(Turns.FirstOrder(explanation.AngularVelocity.Links[explanation.Orientation.Missed[0]].At.Turn));

        private static Vector AngleDifference(Observation o)
        {
            Vector d = Turns.Euler(o.After.Orientation) - Turns.Euler(o.Before.Orientation);
            return new Vector(Math.IEEERemainder(d.X, 2 * Math.PI), Math.IEEERemainder(d.Y, 2 * Math.PI), Math.IEEERemainder(d.Z, 2 * Math.PI));
        }

        /// <summary>k ω of q + [0, ½k ω], where the product with q is left out.</summary>
        private static Vector WithoutOrientation(Observation o)
        {
            Orientation q0 = o.Before.Orientation, q1 = o.After.Orientation;
            return 2 * ((q0.W / q1.W) * q1.Imaginary - q0.Imaginary);
        }

        /// <summary>k ω of [0, ω] q, where nothing is added: half a revolution about ω.</summary>
        private static Vector Pure(Observation o) => Math.Abs(o.Turn.W) < 1e-3 ? o.Turn.Imaginary : new Vector(double.NaN, 0, 0);

        /// <summary>k ω where the components are in the order of the formula, the scalar first, and Unity reads them as x, y, z, w.</summary>
        private static Vector Shifted(Observation o)
        {
            // q1 ∝ (1 + ½k (0, ωx, ωy | ωz)) q0: rotation ∝ vector (0, ½kωx, ½kωy), scalar 1 + ½kωz
            Orientation t = o.Turn;
            Vector w = o.After.AngularVelocity ?? Vector.Zero;
            double along = 2 * t.Imaginary.Y / (t.W * w.X - t.Imaginary.Y * w.Z);
            return Math.Abs(t.Imaginary.X) < 1e-6 && Math.Abs(t.Imaginary.Z * w.X - t.Imaginary.Y * w.Y) < 1e-5 * w.Length ? along * w : new Vector(double.NaN, 0, 0);
        }
    }
}
