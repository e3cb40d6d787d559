namespace RigidBodyDynamics
{
    /// <summary>
    /// Constants of an asymmetric top that depend on its moments alone. Axis 2 has the middle moment and is unstable; the moments
    /// are divided by I₂, since only their ratios determine the motion, and a body of 1e-18 kg m² is like any other.
    /// </summary>
    /// <remarks>
    /// Euler's equations w₁' = k₁ w₂ w₃ (and cyclic) conserve A₁ = I₁ w₁² + g₁ w₂² and A₃ = I₃ w₃² + g₃ w₂², each a sum of
    /// positive terms: 2T = A₁ + A₃ and L² = I₁ A₁ + I₃ A₃. The sign of Q = g₃ A₁ − g₁ A₃ tells the side of the separatrix;
    /// Q is zero on it, and near axis 2 it holds the digits that T and L² have lost.
    /// </remarks>
    internal sealed class TopShape
    {
        private LongTurn _long;

        /// <summary>From principal moments, kg m², and the quaternion that takes principal axes to body axes.</summary>
        public TopShape(Vector3d principalMoments, Quaterniond frame)
        {
            Axes = new PrincipalAxesOrder(principalMoments, frame, FirstOf(principalMoments));
            Vector3d moments = Axes.Moments;
            double scale = moments.Y;
            I1 = moments.X / scale;
            I3 = moments.Z / scale;
            InverseMoments = new Vector3d(1 / moments.X, 1 / moments.Y, 1 / moments.Z);
            // from the moments as given: the difference of two close numbers is exact
            double d12 = (moments.X - moments.Y) / scale, d23 = (moments.Y - moments.Z) / scale, d31 = (moments.Z - moments.X) / scale;
            K1 = d23 / I1;
            K2 = d31;
            K3 = d12 / I3;
            G1 = -d23 / d31;
            G3 = -d12 / d31;
            M1 = G3 * I1;
            M3 = G1 * I3;
            AlphaOfA3 = d31 * -d23 / (I1 * I3);
            BetaOfA1 = d31 * -d12 / (I1 * I3);
            DeltaOfQ = -d31 * d31 / (I1 * I3);
        }

        public readonly PrincipalAxesOrder Axes;

        /// <summary>The same in twice the digits; created at the first use.</summary>
        public LongTurn Long => _long ?? (_long = new LongTurn(Axes.Moments));

        /// <summary>One over the moments as given, in the order of the axes.</summary>
        public readonly Vector3d InverseMoments;

        /// <summary>I₁/I₂ and I₃/I₂; all below in units of I₂.</summary>
        public readonly double I1, I3;

        /// <summary>Coefficients of Euler's equations, and of A₁ and A₃.</summary>
        public readonly double K1, K2, K3, G1, G3;

        /// <summary>Coefficients of Q = M₁ w₁² − M₃ w₃².</summary>
        public readonly double M1, M3;

        /// <summary>α over A₃, β over A₁, α − β over Q.</summary>
        public readonly double AlphaOfA3, BetaOfA1, DeltaOfQ;

        /// <summary>The axis that comes first so that the middle moment is second.</summary>
        private static int FirstOf(Vector3d i) => IsBetween(i.X, i.Y, i.Z) ? 0 : IsBetween(i.Y, i.Z, i.X) ? 1 : 2;

        private static bool IsBetween(double a, double b, double c) => (a <= b && b <= c) || (a >= b && b >= c);
    }
}
