using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The constants of a step of free rotation that are equal for all points of an orbit: S, c₁ = 1 − V1,
    /// c₃ = 1 − V3 for the angular velocity, and 1/L², sin(ψ/2)/|L|, 1 − cos(ψ/2) for the orientation. By + − × ÷ √ alone.
    /// </summary>
    /// <remarks>
    /// S' = c₁ c₃, c₁' = −α S c₃, c₃' = −β S c₁ (Jacobi's sn, cn, dn up to scale). ψ, the rotation about L that remains
    /// after the smallest rotation between the two momenta, obeys
    /// ψ' = |L| (2T + A₁ c₁ + A₃ c₃) / (L² + I₁ A₁ c₁ + I₃ A₃ c₃). With m = (M + M₊)/2 and h = (M₊ − M)/2 the two rotations
    /// together are r ~ (c |m|², c (h × m) + |L| sin(ψ/2) m), c = cos(ψ/2), because M₊ × M = 2 h × m. Its length is |L| |m|, and
    /// |m|² = L² (1 − ε) with ε = |h|²/L², because M and M₊ both have the length of L. So |L| is a constant of the orbit, and the
    /// other divisor, √(1 − ε), is a power series where the step is short.
    /// Series up to h¹¹ for at most 0.06 rad; a longer step is a short one doubled repeatedly by the addition
    /// theorems (S, c₁, c₃) and by the spherical excess of three momenta (ψ).
    /// A rounding error of sin(ψ/2)/|L| would be the same in every step, and grow with their number. A step that repeats stores that
    /// error beside it, from twice the digits.
    /// </remarks>
    internal struct OrbitStep
    {
        // the first term left out of the series is below 2^-52 of S, c₁, c₃ and ψ
        internal const double ShortSquared = 0.06 * 0.06;
        internal const double IllConditioned = 0.02;

        // more than any finite step needs: an infinite angular velocity ends as a state that is not finite, and not as a loop
        internal const int MostDoublings = 1100;
        internal const double F3 = 1 / 6.0, F4 = 1 / 24.0, F5 = 1 / 120.0, F6 = 1 / 720.0, F7 = 1 / 5040.0;
        internal const double F8 = 1 / 40320.0, F9 = 1 / 362880.0, F10 = 1 / 3628800.0, F11 = 1 / 39916800.0;

        public double S, C1, C3;

        // 1 − c, which c near one has lost; used by short steps
        public double V1, V3;

        /// <summary>1/L², sin(ψ/2)/|L| and 1 − cos(ψ/2).</summary>
        public double InverseSquare, Sine, Versine;

        /// <summary>The relative rounding error of <see cref="Sine"/>, which would be the same in every step.</summary>
        public double SineLost;

        /// <summary>
        /// True where a part of the step ends near the opposite of its beginning: the smallest rotation between the two is then
        /// ill-conditioned, and ψ with it. Another number of parts avoids it.
        /// </summary>
        public bool IsIllConditioned;

        /// <summary>
        /// The constants for a step h of the orbit with these A₁, A₃ and Q (moments in units of I₂). For a step that repeats, with their
        /// rounding errors, computed from w.
        /// </summary>
        public void Set(TopShape shape, double a1, double a3, double q, double h, in Vector3d w = default(Vector3d), in Vector3d wLost = default(Vector3d), bool isKept = false)
        {
            double alpha = shape.AlphaOfA3 * a3, beta = shape.BetaOfA1 * a1;
            double energy = a1 + a3, momentum = shape.I1 * a1 + shape.I3 * a3, inverse = 1 / momentum, f0 = energy * inverse;
            double fastest = Math.Max(Math.Max(alpha, beta), energy * f0);
            IsIllConditioned = false;
            int doublings = 0;
            for (double angle = fastest * h * h; angle > ShortSquared && doublings < MostDoublings; angle *= 0.25, h *= 0.5)
                doublings++;

            double x = alpha * h * h, y = beta * h * h, p = x + y, m = x * y, xx = x * x, yy = y * y, pp = p * p;
            S = h * (1 - F3 * p + F5 * (pp + 12 * m) - F7 * p * (pp + 132 * m)
                + F9 * (pp * pp + m * (1224 * pp + 3024 * m)) - F11 * p * (pp * pp + m * (11064 * pp + 132624 * m)));
            double c11 = -0.5 * x, c12 = F4 * x * (x + 4 * y), c13 = -F6 * x * (xx + 44 * m + 16 * yy);
            double c14 = F8 * x * (x * (xx + 408 * m + 912 * yy) + 64 * y * yy);
            double c15 = -F10 * x * (xx * (xx + 3688 * m + 30768 * yy) + yy * (15808 * m + 256 * yy));
            double c31 = -0.5 * y, c32 = F4 * y * (y + 4 * x), c33 = -F6 * y * (yy + 44 * m + 16 * xx);
            double c34 = F8 * y * (y * (yy + 408 * m + 912 * xx) + 64 * x * xx);
            double c35 = -F10 * y * (yy * (yy + 3688 * m + 30768 * xx) + xx * (15808 * m + 256 * xx));
            V1 = -(c11 + (c12 + (c13 + (c14 + c15))));
            V3 = -(c31 + (c32 + (c33 + (c34 + c35))));
            C1 = 1 - V1;
            C3 = 1 - V3;

            // ψ/h over |L| as the quotient of two series, integrated term by term
            double half = 0.5 * inverse, e1 = half * a1, e3 = half * a3, l1 = shape.I1 * e1, l3 = shape.I3 * e3;
            double d1 = l1 * c11 + l3 * c31, d2 = l1 * c12 + l3 * c32;
            double d3 = l1 * c13 + l3 * c33, d4 = l1 * c14 + l3 * c34, d5 = l1 * c15 + l3 * c35;
            double f1 = e1 * c11 + e3 * c31 - f0 * d1;
            double f2 = e1 * c12 + e3 * c32 - f0 * d2 - f1 * d1;
            double f3 = e1 * c13 + e3 * c33 - f0 * d3 - f1 * d2 - f2 * d1;
            double f4 = e1 * c14 + e3 * c34 - f0 * d4 - f1 * d3 - f2 * d2 - f3 * d1;
            double f5 = e1 * c15 + e3 * c35 - f0 * d5 - f1 * d4 - f2 * d3 - f3 * d2 - f4 * d1;
            double rest = 1 / 6.0 * f1 + (0.1 * f2 + (1 / 14.0 * f3 + (1 / 18.0 * f4 + 1 / 22.0 * f5)));
            double f = h * (0.5 * f0 + rest), u = momentum * f * f, bent = u * (F3 - u * (F5 - u * F7));
            Sine = f - f * bent;
            Versine = u * (0.5 - u * (F4 - u * (F6 - u * F8)));
            InverseSquare = inverse;
            SineLost = 0;
            if (doublings == 0 && !isKept)
                return;

            DoubleDouble length = doublings > 0 ? Math.Sqrt(momentum) : 0, exact = Sine;
            if (isKept)
            {
                shape.Long.Invariants(new Vector3dd(w, wLost), out DoubleDouble longEnergy, out DoubleDouble square);
                length = DoubleDouble.Sqrt(square);
                exact = (1 - (DoubleDouble)bent) * (h * (0.5 * longEnergy / square + rest));
                SineLost = (exact - Sine).High / Sine;
            }

            if (doublings > 0)
                Double(doublings, shape, a1, a3, shape.DeltaOfQ * q, length, exact, isKept);
        }

        private void Double(int times, TopShape shape, double a1, double a3, double delta, DoubleDouble exactLength, DoubleDouble exactSine, bool isKept)
        {
            double alpha = shape.AlphaOfA3 * a3, beta = shape.BetaOfA1 * a1;
            double length = exactLength.High, v = Versine, sin = length * Sine;
            // the rounding error of the angle ψ/2, which matters most where the angle is small
            double lost = (exactLength * exactSine - sin).High;
            double i1A1 = shape.I1 * a1, i3A3 = shape.I3 * a3, turned = (shape.I3 - shape.I1) * a1 * a3;
            for (int i = 0; i < times; i++)
            {
                double c1 = C1, c3 = C3, c11 = c1 * c1, c33 = c3 * c3, ss = S * S;
                double apart = c1 + c3 > 0.2 ? delta * ss / (c1 + c3) : c3 - c1;
                double excessSine = turned * S * apart;
                double excessCosine = length * (i1A1 * c1 * (1 + c1) + i3A3 * c3 * (1 + c3));
                double excess = Math.Sqrt(excessSine * excessSine + excessCosine * excessCosine), r = 1 / excess;
                IsIllConditioned |= excess < IllConditioned * length * (i1A1 + i3A3);
                double x = excessCosine * r, y = excessSine * r;

                bool isNear = Math.Abs(c1) >= 0.7 && Math.Abs(c3) >= 0.7;
                double d = 1 / (isNear ? 1 - alpha * beta * ss * ss : c11 + alpha * ss * c33);
                V1 = 2 * alpha * ss * c33 * d;
                V3 = 2 * beta * ss * c11 * d;
                C1 = isNear ? 1 - V1 : (c11 * c33 - delta * ss) * d;
                C3 = isNear ? 1 - V3 : (c11 * c33 + delta * ss) * d;
                S = 2 * S * c1 * c3 * d;

                // ψ is doubled and reduced by the excess: of 2 sin(ψ/2) only the reduction is computed, so that it keeps its digits
                double w = x > 0 ? y * y / (1 + x) : 1 - x, twice = 2 * sin, square = twice * sin;
                double lack = twice * (v + w - v * w) + (1 - square) * y;
                sin = twice - lack;
                v = square + (w - square * w) - twice * (1 - v) * y;
                // each doubling squares the error of their length
                double off = v - 0.5 * (v * v + sin * sin);
                lost = 2 * lost + (1 - v) * ((twice - sin) - lack + sin * off);
                v -= off - v * off;
            }

            if (isKept)
            {
                DoubleDouble all = (DoubleDouble)sin + lost * (1 - v);
                v += lost * sin;
                sin = all.High;
                SineLost = (all - sin / length * exactLength).High / sin;
            }

            Sine = sin / length;
            Versine = v;
        }
    }
}
