#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>
    /// <see cref="OrbitStep"/> for several bodies at once: the same operations in the same order. Each lane is doubled as often as
    /// it needs; both sides of a branch are computed, and each lane takes its own.
    /// </summary>
    internal struct OrbitLanes
    {
        public Lanes S, C1, C3, V1, V3, InverseSquare, Sine, Versine;

        public Masks IsIllConditioned;

        [MethodImpl(Kernel.Compiled)]
        public void Set(TopShape shape, Lanes a1, Lanes a3, Lanes q, Lanes h)
        {
            Lanes one = Lanes.One, alpha = shape.AlphaOfA3 * a3, beta = shape.BetaOfA1 * a1;
            Lanes energy = a1 + a3, momentum = shape.I1 * a1 + shape.I3 * a3, inverse = one / momentum, f0 = energy * inverse;
            Lanes fastest = Vector.Max(Vector.Max(alpha, beta), energy * f0), angle = fastest * h * h, times = Lanes.Zero;
            int doublings = 0;
            for (; Vector.GreaterThanAny(angle, new Lanes(OrbitStep.ShortSquared)) && doublings < OrbitStep.MostDoublings; doublings++)
            {
                Masks isLong = Vector.GreaterThan(angle, new Lanes(OrbitStep.ShortSquared));
                times += Vector.ConditionalSelect(isLong, one, Lanes.Zero);
                h = Vector.ConditionalSelect(isLong, 0.5 * h, h);
                angle = Vector.ConditionalSelect(isLong, 0.25 * angle, angle);
            }

            Lanes x = alpha * h * h, y = beta * h * h, p = x + y, m = x * y, xx = x * x, yy = y * y, pp = p * p;
            S = h * (one - OrbitStep.F3 * p + OrbitStep.F5 * (pp + 12 * m) - OrbitStep.F7 * p * (pp + 132 * m)
                + OrbitStep.F9 * (pp * pp + m * (1224 * pp + 3024 * m)) - OrbitStep.F11 * p * (pp * pp + m * (11064 * pp + 132624 * m)));
            Lanes c11 = -0.5 * x, c12 = OrbitStep.F4 * x * (x + 4 * y), c13 = -OrbitStep.F6 * x * (xx + 44 * m + 16 * yy);
            Lanes c14 = OrbitStep.F8 * x * (x * (xx + 408 * m + 912 * yy) + 64 * y * yy);
            Lanes c15 = -OrbitStep.F10 * x * (xx * (xx + 3688 * m + 30768 * yy) + yy * (15808 * m + 256 * yy));
            Lanes c31 = -0.5 * y, c32 = OrbitStep.F4 * y * (y + 4 * x), c33 = -OrbitStep.F6 * y * (yy + 44 * m + 16 * xx);
            Lanes c34 = OrbitStep.F8 * y * (y * (yy + 408 * m + 912 * xx) + 64 * x * xx);
            Lanes c35 = -OrbitStep.F10 * y * (yy * (yy + 3688 * m + 30768 * xx) + xx * (15808 * m + 256 * xx));
            V1 = -(c11 + (c12 + (c13 + (c14 + c15))));
            V3 = -(c31 + (c32 + (c33 + (c34 + c35))));
            C1 = one - V1;
            C3 = one - V3;

            Lanes half = 0.5 * inverse, e1 = half * a1, e3 = half * a3, l1 = shape.I1 * e1, l3 = shape.I3 * e3;
            Lanes d1 = l1 * c11 + l3 * c31, d2 = l1 * c12 + l3 * c32;
            Lanes d3 = l1 * c13 + l3 * c33, d4 = l1 * c14 + l3 * c34;
            Lanes d5 = l1 * c15 + l3 * c35;
            Lanes f1 = e1 * c11 + e3 * c31 - f0 * d1;
            Lanes f2 = e1 * c12 + e3 * c32 - f0 * d2 - f1 * d1;
            Lanes f3 = e1 * c13 + e3 * c33 - f0 * d3 - f1 * d2 - f2 * d1;
            Lanes f4 = e1 * c14 + e3 * c34 - f0 * d4 - f1 * d3 - f2 * d2 - f3 * d1;
            Lanes f5 = e1 * c15 + e3 * c35 - f0 * d5 - f1 * d4 - f2 * d3 - f3 * d2 - f4 * d1;
            Lanes rest = 1 / 6.0 * f1 + (0.1 * f2 + (1 / 14.0 * f3 + (1 / 18.0 * f4 + 1 / 22.0 * f5)));
            Lanes f = h * (0.5 * f0 + rest), u = momentum * f * f;
            Lanes bent = u * (new Lanes(OrbitStep.F3) - u * (new Lanes(OrbitStep.F5) - u * OrbitStep.F7));
            Sine = f - f * bent;
            Versine = u * (new Lanes(0.5) - u * (new Lanes(OrbitStep.F4) - u * (new Lanes(OrbitStep.F6) - u * OrbitStep.F8)));
            InverseSquare = inverse;
            IsIllConditioned = Masks.Zero;
            if (doublings > 0)
                Double(doublings, times, shape, a1, a3, alpha, beta, shape.DeltaOfQ * q, Vector.SquareRoot(momentum));
        }

        private void Double(int most, Lanes times, TopShape shape, Lanes a1, Lanes a3, Lanes alpha, Lanes beta, Lanes delta, Lanes length)
        {
            Lanes one = Lanes.One, v = Versine, sin = length * Sine;
            Lanes i1A1 = shape.I1 * a1, i3A3 = shape.I3 * a3, turned = (shape.I3 - shape.I1) * a1 * a3;
            for (int i = 0; i < most; i++)
            {
                Masks isOn = Vector.GreaterThan(times, new Lanes(i));
                Lanes s = S, c1 = C1, c3 = C3, c11 = c1 * c1, c33 = c3 * c3, ss = s * s;
                Lanes apart = Vector.ConditionalSelect(Vector.GreaterThan(c1 + c3, new Lanes(0.2)), delta * ss / (c1 + c3), c3 - c1);
                Lanes excessSine = turned * s * apart;
                Lanes excessCosine = length * (i1A1 * c1 * (one + c1) + i3A3 * c3 * (one + c3));
                Lanes excess = Vector.SquareRoot(excessSine * excessSine + excessCosine * excessCosine), r = one / excess;
                IsIllConditioned |= isOn & Vector.LessThan(excess, OrbitStep.IllConditioned * length * (i1A1 + i3A3));
                Lanes x = excessCosine * r, y = excessSine * r;

                Masks isNear = Vector.GreaterThanOrEqual(Vector.Abs(c1), new Lanes(0.7)) & Vector.GreaterThanOrEqual(Vector.Abs(c3), new Lanes(0.7));
                Lanes d = one / Vector.ConditionalSelect(isNear, one - alpha * beta * ss * ss, c11 + alpha * ss * c33);
                Lanes v1 = 2 * alpha * ss * c33 * d, v3 = 2 * beta * ss * c11 * d;
                Lanes far1 = (c11 * c33 - delta * ss) * d, far3 = (c11 * c33 + delta * ss) * d;
                C1 = Vector.ConditionalSelect(isOn, Vector.ConditionalSelect(isNear, one - v1, far1), C1);
                C3 = Vector.ConditionalSelect(isOn, Vector.ConditionalSelect(isNear, one - v3, far3), C3);
                V1 = Vector.ConditionalSelect(isOn, Vector.ConditionalSelect(isNear, v1, one - far1), V1);
                V3 = Vector.ConditionalSelect(isOn, Vector.ConditionalSelect(isNear, v3, one - far3), V3);
                S = Vector.ConditionalSelect(isOn, 2 * s * c1 * c3 * d, s);

                Lanes w = Vector.ConditionalSelect(Vector.GreaterThan(x, Lanes.Zero), y * y / (one + x), one - x);
                Lanes twice = 2 * sin, square = twice * sin, nextSin = twice - (twice * (v + w - v * w) + (one - square) * y);
                Lanes nextV = square + (w - square * w) - twice * (one - v) * y, off = nextV - 0.5 * (nextV * nextV + nextSin * nextSin);
                sin = Vector.ConditionalSelect(isOn, nextSin, sin);
                v = Vector.ConditionalSelect(isOn, nextV - (off - nextV * off), v);
            }

            Masks isDoubled = Vector.GreaterThan(times, Lanes.Zero);
            Sine = Vector.ConditionalSelect(isDoubled, sin / length, Sine);
            Versine = v;
        }
    }
}
#endif
