using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The code that the sheet hands out: the keys' forces, the torque, I_ref.</summary>
    internal static class GivenCode
    {
        public static IEnumerable<Finding> Findings(IReadOnlyList<Observation> frames, Explanation explanation)
        {
            Observation[] left = frames.Where(o => o.IsLeftToKeys).ToArray();
            Observation force = left.FirstOrDefault(o => o.After.Force.HasValue && Differs(o.After.Force.Value, o.KeyForce));
            if (force != null && UsesVariable(explanation.Velocity, o => o.KeyForce))
                yield return Words.Finding(Step.Given, "force-changed", Text.Of(force.KeyForce), Text.Of(force.After.Force.Value)).From(force.Run.Name, force.Index);
            Observation torque = left.FirstOrDefault(o => o.After.Torque.HasValue && Differs(o.After.Torque.Value, o.KeyTorque));
            if (torque != null && UsesVariable(explanation.AngularVelocity, o => o.KeyTorque))
                yield return Words.Finding(Step.Given, "torque-changed", Text.Of(torque.KeyTorque), Text.Of(torque.After.Torque.Value)).From(torque.Run.Name, torque.Index);
            foreach (Run run in frames.Select(o => o.Run).Distinct())
            {
                Observation first = frames.First(o => o.Run == run);
                if (run.InertiaAtStart.HasValue && !IsInertia(run.InertiaAtStart.Value, first))
                {
                    yield return Words.Finding(Step.Given, "inertia-changed", Text.Of(first.Mass * Diagonal(Matrix.InertiaOf(run.Setting.Vertices))), Text.Of(Diagonal(run.InertiaAtStart.Value))).From(run.Name, 0);
                    yield break;
                }
            }
        }

        private static bool Differs(Vector a, Vector b) => !((a - b).Length <= 1e-4 * (1 + b.Length));

        /// <summary>The steps are driven by the variable and not by the keys: what the variable holds counts.</summary>
        private static bool UsesVariable(Chain chain, System.Func<Observation, Vector> keys) =>
            !chain.GainIsRight || chain.Links.Any(l => l.At.IsLeftToKeys && (l.Gain.Length > 1e-6) != (keys(l.At).Length > 1e-6)) || IsScaled(chain, keys);

        private static bool IsScaled(Chain chain, System.Func<Observation, Vector> keys) =>
            Coefficients.Median(chain.Links.Where(l => l.At.IsLeftToKeys && keys(l.At).Length > 0.1).Select(l => l.Gain.Length / keys(l.At).Length)) > 0;

        /// <summary>I_ref of the mesh or of the cube, or the inverse of one of them.</summary>
        private static bool IsInertia(Matrix found, Observation at)
        {
            Matrix mesh = at.Mass * Matrix.InertiaOf(at.Run.Setting.Vertices), cube = (at.Mass / 2) * Matrix.Identity;
            return new[] { mesh, cube, mesh.Inverse, cube.Inverse }.Any(expected => (found - expected).Size <= 1e-3 * expected.Size);
        }

        private static Vector Diagonal(Matrix m) => new Vector(m.Row0.X, m.Row1.Y, m.Row2.Z);
    }
}
