using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>The 3×3 matrix of an orientation, row by row; its columns are the body's axes in the world.</summary>
    internal struct Matrix3
    {
        /// <summary>First row.</summary>
        public Vector3d Row1;

        /// <summary>Second row.</summary>
        public Vector3d Row2;

        /// <summary>Third row.</summary>
        public Vector3d Row3;

        /// <summary>The matrix with the given rows.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Matrix3(Vector3d row1, Vector3d row2, Vector3d row3)
        {
            Row1 = row1;
            Row2 = row2;
            Row3 = row3;
        }

        /// <summary>
        /// R of a quaternion, by the lab's formula 1 − 2(yy + zz), 2(xy − wz), ... A rotation only if the length of q is 1; otherwise
        /// the formula is used as it stands, as in a script that does not normalise.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Matrix3 Of(Quaterniond q)
        {
            double xx = q.X * q.X, yy = q.Y * q.Y, zz = q.Z * q.Z;
            double xy = q.X * q.Y, xz = q.X * q.Z, yz = q.Y * q.Z;
            double wx = q.W * q.X, wy = q.W * q.Y, wz = q.W * q.Z;
            return new Matrix3(
                new Vector3d(1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)),
                new Vector3d(2 * (xy + wz), 1 - 2 * (xx + zz), 2 * (yz - wx)),
                new Vector3d(2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)));
        }

        /// <summary>Matrix times vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector3d operator *(Matrix3 m, Vector3d v) =>
            new Vector3d(Vector3d.Dot(m.Row1, v), Vector3d.Dot(m.Row2, v), Vector3d.Dot(m.Row3, v));
    }
}
