using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Principal moments and axes of an inertia tensor: A = F diag(moments) Fᵀ with F the matrix of the frame.
    /// Jacobi's rotations (Golub, Van Loan, Matrix Computations, section 8.5), once per body and never in a step.
    /// </summary>
    internal static class PrincipalAxes
    {
        private const int MostSweeps = 30;

        /// <summary>
        /// Diagonalises A. A diagonal tensor keeps its axes and their order. The error of the moments is a few roundings of the largest.
        /// </summary>
        /// <param name="tensor">The tensor in body axes, kg m².</param>
        /// <param name="frame">Takes the principal axes to the body axes; of length 1.</param>
        /// <returns>The three principal moments, in the order of the frame's axes.</returns>
        public static Vector3d Of(SymmetricMatrix3 tensor, out Quaterniond frame)
        {
            // only ratios matter for the axes: scaled to 1, no square can over- or underflow
            double size = Size(tensor);
            SymmetricMatrix3 a = size > 0 ? new SymmetricMatrix3(tensor.Diagonal / size, tensor.OffDiagonal / size) : tensor;
            frame = Quaterniond.Identity;
            for (int sweep = 0; sweep < MostSweeps && !a.OffDiagonal.IsZero; sweep++)
            {
                frame = frame * Turn(ref a, 0);
                frame = frame * Turn(ref a, 1);
                frame = (frame * Turn(ref a, 2)).Normalized;
            }

            return size * a.Diagonal;
        }

        private static double Size(SymmetricMatrix3 a)
        {
            double diagonal = Math.Max(Math.Abs(a.Diagonal.X), Math.Max(Math.Abs(a.Diagonal.Y), Math.Abs(a.Diagonal.Z)));
            double beside = Math.Max(Math.Abs(a.OffDiagonal.X), Math.Max(Math.Abs(a.OffDiagonal.Y), Math.Abs(a.OffDiagonal.Z)));
            return Math.Max(diagonal, beside);
        }

        /// <summary>One rotation about an axis, by the angle that makes the opposite off-diagonal number zero.</summary>
        private static Quaterniond Turn(ref SymmetricMatrix3 a, int axis)
        {
            // cyclic renaming, so that the plane of the rotation is always (p, q)
            double app, aqq, apq, arp, arq;
            switch (axis)
            {
                case 0: app = a.Diagonal.Y; aqq = a.Diagonal.Z; apq = a.OffDiagonal.X; arp = a.OffDiagonal.Z; arq = a.OffDiagonal.Y; break;
                case 1: app = a.Diagonal.Z; aqq = a.Diagonal.X; apq = a.OffDiagonal.Y; arp = a.OffDiagonal.X; arq = a.OffDiagonal.Z; break;
                default: app = a.Diagonal.X; aqq = a.Diagonal.Y; apq = a.OffDiagonal.Z; arp = a.OffDiagonal.Y; arq = a.OffDiagonal.X; break;
            }

            // a number that no longer changes its neighbours by half an ulp counts as zero
            if (app + apq == app && aqq + apq == aqq && Math.Abs(apq) <= 1e-18)
                apq = 0;

            double t = 0, cos = 1, sin = 0;
            if (apq != 0)
            {
                // t = tan of the angle: the smaller root of t² + 2 theta t − 1 = 0
                double theta = (aqq - app) / (2 * apq);
                t = theta >= 0 ? 1 / (theta + Math.Sqrt(1 + theta * theta)) : 1 / (theta - Math.Sqrt(1 + theta * theta));
                cos = 1 / Math.Sqrt(1 + t * t);
                sin = t * cos;
            }

            app -= t * apq;
            aqq += t * apq;
            double newRp = cos * arp - sin * arq, newRq = sin * arp + cos * arq;
            // the half angle, without trigonometry; the rotation that takes new axes to old is the inverse
            double halfCos = Math.Sqrt(0.5 * (1 + cos)), halfSin = -0.5 * sin / halfCos;
            switch (axis)
            {
                case 0:
                    a.Diagonal.Y = app; a.Diagonal.Z = aqq; a.OffDiagonal = new Vector3d(0, newRq, newRp);
                    return new Quaterniond(halfCos, halfSin, 0, 0);
                case 1:
                    a.Diagonal.Z = app; a.Diagonal.X = aqq; a.OffDiagonal = new Vector3d(newRp, 0, newRq);
                    return new Quaterniond(halfCos, 0, halfSin, 0);
                default:
                    a.Diagonal.X = app; a.Diagonal.Y = aqq; a.OffDiagonal = new Vector3d(newRq, newRp, 0);
                    return new Quaterniond(halfCos, 0, 0, halfSin);
            }
        }
    }
}
