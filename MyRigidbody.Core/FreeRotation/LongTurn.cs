using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Free rotation of a body with three different moments over a time of any length, in twice the digits: the error of a million
    /// revolutions in one call is that of the inputs. The formulas are those of <see cref="OrbitStep"/> and
    /// <see cref="AsymmetricTop"/>, in the form that cancels near the unstable axis, which so many digits allow.
    /// </summary>
    internal sealed class LongTurn
    {
        // the later terms of the series are below 1e-5 of the first, so a double holds them to 1e-21 of it
        private const double ShortSquared = 1.0 / (128 * 128);
        // below this square of their sum (of 4), two momenta are nearly opposite, and the smallest rotation between them is not used
        private const double Opposite = 1e-12;
        private const int MostDoublings = 200;

        private readonly Vector3dd _moments;
        private readonly DoubleDouble _k1, _k2, _k3, _g1, _g3, _alphaOfA3, _betaOfA1;

        /// <summary>For moments the second of which is the middle one.</summary>
        public LongTurn(Vector3d moments)
        {
            DoubleDouble i1 = (DoubleDouble)moments.X / moments.Y, i3 = (DoubleDouble)moments.Z / moments.Y;
            DoubleDouble d12 = i1 - 1, d23 = 1 - i3, d31 = i3 - i1;
            _moments = new Vector3dd(i1, 1, i3);
            _k1 = d23 / i1;
            _k2 = d31;
            _k3 = d12 / i3;
            _g1 = -d23 / d31;
            _g3 = -d12 / d31;
            _alphaOfA3 = d31 * -d23 / (i1 * i3);
            _betaOfA1 = d31 * -d12 / (i1 * i3);
        }

        /// <summary>Rotates a body: its orientation, and its angular velocity in body axes, rad per unit of time.</summary>
        public void Advance(ref Quaterniondd q, ref Vector3dd w, DoubleDouble time)
        {
            // in units in which the energy is about one, so that squares of squares do not underflow
            DoubleDouble unit = Math.Sqrt(Vector3dd.Dot(w, Vector3dd.Scale(_moments, w)).High);
            Vector3dd inUnits = 1 / unit * w;
            Turn(ref q, ref inUnits, time * unit);
            w = unit * inUnits;
        }

        /// <summary>2T, L² and, returned, Q.</summary>
        public DoubleDouble Invariants(in Vector3dd w, out DoubleDouble energy, out DoubleDouble square)
        {
            Vector3dd m = Vector3dd.Scale(_moments, w);
            energy = Vector3dd.Dot(m, w);
            square = Vector3dd.Dot(m, m);
            return _g3 * (m.X * w.X) - _g1 * (m.Z * w.Z);
        }

        private void Turn(ref Quaterniondd q, ref Vector3dd w, DoubleDouble time)
        {
            DoubleDouble a1 = _moments.X * (w.X * w.X) + _g1 * (w.Y * w.Y), a3 = _moments.Z * (w.Z * w.Z) + _g3 * (w.Y * w.Y);
            DoubleDouble momentum = _moments.X * a1 + _moments.Z * a3, length = DoubleDouble.Sqrt(momentum);
            Orbit(a1, a3, momentum, length, time, out DoubleDouble s, out DoubleDouble c1, out DoubleDouble c3, out DoubleDouble cos, out DoubleDouble sin);
            DoubleDouble inverse = 1 / (c1 * c1 - _k1 * _k2 * (s * w.Z) * (s * w.Z));
            Vector3dd after = new Vector3dd(
                (w.X * c1 + _k1 * s * c3 * w.Y * w.Z) * inverse,
                (w.Y * c1 * c3 + _k2 * s * w.Z * w.X) * inverse,
                (w.Z * c3 + _k3 * s * c1 * w.X * w.Y) * inverse);
            Vector3dd m = Vector3dd.Scale(_moments, w), next = Vector3dd.Scale(_moments, after), sum = m + next;
            DoubleDouble square = Vector3dd.Dot(sum, sum);
            if (square.High < Opposite * momentum.High)
            {
                Turn(ref q, ref w, 0.5 * time);
                Turn(ref q, ref w, 0.5 * time);
                return;
            }

            q = (q * new Quaterniondd(0.5 * cos * square, cos * Vector3dd.Cross(next, m) + length * sin * sum)).Normalized;
            w = after;
        }

        /// <summary>S, c₁, c₃ and, up to a common factor, cosine and sine of ψ/2.</summary>
        private void Orbit(
            DoubleDouble a1, DoubleDouble a3, DoubleDouble momentum, DoubleDouble length, DoubleDouble h,
            out DoubleDouble s, out DoubleDouble c1, out DoubleDouble c3, out DoubleDouble cos, out DoubleDouble sin)
        {
            DoubleDouble alpha = _alphaOfA3 * a3, beta = _betaOfA1 * a1, f0 = (a1 + a3) / momentum;
            double fastest = Math.Max(Math.Max(alpha.High, beta.High), ((a1 + a3) * f0).High);
            int doublings = 0;
            for (double angle = fastest * h.High * h.High; angle > ShortSquared && doublings < MostDoublings; angle *= 0.25)
                doublings++;

            for (int i = 0; i < doublings; i++)
                h = 0.5 * h;

            DoubleDouble xx = alpha * (h * h), yy = beta * (h * h);
            double x = xx.High, y = yy.High, p = x + y, m = x * y;
            s = h + h * (OrbitStep.F5 * (p * p + 12 * m) - OrbitStep.F3 * p - OrbitStep.F7 * p * (p * p + 132 * m)
                + OrbitStep.F9 * (p * p * p * p + m * (1224 * p * p + 3024 * m)));
            double c12 = OrbitStep.F4 * x * (x + 4 * y), c32 = OrbitStep.F4 * y * (y + 4 * x), c13 = Third(x, y), c33 = Third(y, x);
            c1 = 1 - 0.5 * xx + (c12 + (c13 + Fourth(x, y)));
            c3 = 1 - 0.5 * yy + (c32 + (c33 + Fourth(y, x)));

            // ψ/h over |L| as the quotient of two series, integrated term by term
            double half = 0.5 / momentum.High, e1 = half * a1.High, e3 = half * a3.High, l1 = _moments.X.High * e1, l3 = _moments.Z.High * e3;
            double d1 = -0.5 * (l1 * x + l3 * y), d2 = l1 * c12 + l3 * c32, f1 = -0.5 * (e1 * x + e3 * y) - f0.High * d1;
            double f2 = e1 * c12 + e3 * c32 - f0.High * d2 - f1 * d1;
            double f3 = e1 * c13 + e3 * c33 - f0.High * (l1 * c13 + l3 * c33) - f1 * d2 - f2 * d1;
            DoubleDouble f = h * (0.5 * f0 + (1 / 6.0 * f1 + 0.1 * f2 + 1 / 14.0 * f3));
            double u = (momentum * f * f).High;
            cos = 1;
            sin = length * (f + f * (u * (1 / 3.0 + u * (2 / 15.0 + u * (17 / 315.0 + u * (62 / 2835.0))))));

            DoubleDouble i1A1 = _moments.X * length * a1, i3A3 = _moments.Z * length * a3, turned = _k2 * a1 * a3;
            for (; doublings > 0; doublings--)
            {
                // the spherical excess by which ψ of the double step is less than twice ψ
                DoubleDouble c11 = c1 * c1, c3c3 = c3 * c3, y1 = turned * s * (c3 - c1), x1 = i1A1 * (c1 + c11) + i3A3 * (c3 + c3c3);
                DoubleDouble ss = s * s, t1 = alpha * ss * c3c3, t3 = beta * ss * c11, inverse = 1 / (c11 + t1);
                s = 2 * s * c1 * c3 * inverse;
                c1 = (c11 - t1) * inverse;
                c3 = (c3c3 - t3) * inverse;
                DoubleDouble cosine = cos * cos - sin * sin, twice = 2 * cos * sin;
                cos = cosine * x1 + twice * y1;
                sin = twice * x1 - cosine * y1;
                double size = 1 / (Math.Abs(cos.High) + Math.Abs(sin.High));
                cos = size * cos;
                sin = size * sin;
            }
        }

        // terms of c₁; those of c₃ with x and y exchanged
        private static double Third(double x, double y) => -OrbitStep.F6 * x * (x * x + 44 * x * y + 16 * y * y);

        private static double Fourth(double x, double y) =>
            OrbitStep.F8 * x * (x * (x * x + 408 * x * y + 912 * y * y) + 64 * y * y * y);
    }
}
