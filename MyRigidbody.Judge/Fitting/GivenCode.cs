using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The given code of the sheet: the keys' forces, the torque, I_ref.</summary>
    internal static class GivenCode
    {
        public static IEnumerable<Finding> Findings(IReadOnlyList<Observation> frames, Explanation explanation)
        {
            Observation[] left = frames.Where(o => o.IsLeftToKeys).ToArray();
            return Push("force-changed", left, explanation.Velocity, o => o.After.Force, o => o.KeyForce)
                .Concat(Push("torque-changed", left, explanation.AngularVelocity, o => o.After.Torque, o => o.KeyTorque))
                .Concat(Inertia(frames)).Concat(Start(frames));
        }

        /// <summary>
        /// Finds a variable that differs from the keys' value and that the steps use. Steps that are right with the keys' own values do
        /// not use it; where steps are wrong, a variable that is zero after every frame has been cleared and proves nothing.
        /// </summary>
        private static IEnumerable<Finding> Push(string code, Observation[] frames, Chain chain, Func<Observation, Vector?> variable, Func<Observation, Vector> keys)
        {
            Observation[] seen = frames.Where(o => variable(o).HasValue).ToArray();
            Observation first = seen.FirstOrDefault(o => Differs(variable(o).Value, keys(o)));
            bool isCleared = seen.All(o => variable(o).Value.Length == 0);
            bool isUsed = chain.GainIsRight ? chain.Source == Source.Variable : !isCleared;
            if (first != null && isUsed)
                yield return Words.Finding(Step.Given, code, Text.Of(keys(first)), Text.Of(variable(first).Value)).From(first.Run.Name, first.Index);
        }

        private static IEnumerable<Finding> Inertia(IReadOnlyList<Observation> frames)
        {
            Observation first = frames.FirstOrDefault(o => o.Index == 0 && o.Run.InertiaAtStart.HasValue && !IsInertia(o.Run.InertiaAtStart.Value, o));
            if (first != null)
            {
                Vector expected = Diagonal(first.Mass * first.Run.InertiaOfMesh);
                yield return Words.Finding(Step.Given, "inertia-changed", Text.Of(expected), Text.Of(Diagonal(first.Run.InertiaAtStart.Value))).From(first.Run.Name, 0);
            }
        }

        /// <summary>Tests that the body is at rest when the scene begins.</summary>
        private static IEnumerable<Finding> Start(IReadOnlyList<Observation> frames)
        {
            Observation first = frames[0];
            Vector v = first.Before.Velocity ?? Vector.Zero, w = first.Before.AngularVelocity ?? Vector.Zero;
            if (!(v.Length <= 1e-4 && w.Length <= 1e-4))
                yield return Words.Finding(Step.Given, "starts-moving", "v = 0, ω = 0", $"v = {Text.Of(v)}, ω = {Text.Of(w)}").From(first.Run.Name, 0);
        }

        private static bool Differs(Vector a, Vector b) => !((a - b).Length <= 1e-4 * (1 + b.Length));

        /// <summary>True for I_ref of the mesh or of the cube, or the inverse of one of them.</summary>
        private static bool IsInertia(Matrix found, Observation at)
        {
            Matrix mesh = at.Mass * at.Run.InertiaOfMesh, cube = (at.Mass / 2) * Matrix.Identity;
            return new[] { mesh, cube, mesh.Inverse, cube.Inverse }.Any(expected => (found - expected).Size <= 1e-3 * expected.Size);
        }

        private static Vector Diagonal(Matrix m) => new Vector(m.Row0.X, m.Row1.Y, m.Row2.Z);
    }
}
