using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Admissible values of I_ref and R in a script.</summary>
    internal static class Inertias
    {
        public static readonly IReadOnlyList<Func<Observation, Matrix>> References = new Func<Observation, Matrix>[] { Kept, OfMesh, AtStart, OfCube };

        /// <summary>R of the orientation before the frame, of the script's own quaternion of any length, and after the frame.</summary>
        public static readonly IReadOnlyList<Func<Observation, Matrix>> Rotations = new Func<Observation, Matrix>[]
        {
            o => Matrix.Rotation(o.Before.Orientation.Normalized),
            o => Matrix.Rotation(o.Before.OwnOrientation ?? o.Before.Orientation),
            o => Matrix.Rotation(o.After.Orientation.Normalized),
        };

        /// <summary>The script's own variable.</summary>
        public static Matrix Kept(Observation o)
        {
            Matrix? kept = o.Before.Inertia;
            if (!kept.HasValue || kept.Value.Size == 0)
                kept = o.After.Inertia;
            return kept.HasValue && kept.Value.IsFinite ? Upright(kept.Value, OfMesh(o)) : OfMesh(o);
        }

        private static Matrix AtStart(Observation o) => o.Run.InertiaAtStart ?? OfMesh(o);

        private static Matrix OfMesh(Observation o) => o.Mass * o.Run.InertiaOfMesh;

        private static Matrix OfCube(Observation o) => (o.Mass / 2) * Matrix.Identity;

        /// <summary>The matrix, or its inverse where it equals the inverse of the mesh's.</summary>
        private static Matrix Upright(Matrix kept, Matrix mesh)
        {
            Matrix inverse = mesh.Inverse;
            bool isInverse = (kept - inverse).Size < 1e-3 * inverse.Size && (kept - mesh).Size > 1e-3 * mesh.Size;
            return isInverse ? kept.Inverse : kept;
        }
    }
}
