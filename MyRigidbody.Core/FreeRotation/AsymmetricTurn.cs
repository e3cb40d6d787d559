using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    internal partial struct AsymmetricTop
    {
        /// <summary>Computes once what every short rotation needs of the constants of the orbit.</summary>
        private void Derive()
        {
            TopShape s = _shape;
            double o = _orbit.S, v1 = _orbit.V1, v3 = _orbit.V3;
            _kOfSquare = s.K1 * s.K3 * (o * o);
            _s1 = s.K1 * (o * (1 - v3));
            _s2 = s.K2 * o;
            _s3 = s.K3 * (o * (1 - v1));
            _v13 = v1 + v3 - v1 * v3;
            _cosine = (1 - _orbit.Versine) * _orbit.InverseSquare;
        }

        /// <summary>Rotates by the prepared step.</summary>
        internal void Turn()
        {
            if (_isShort)
                TurnShort();

            for (long i = _isShort ? 1 : 0; i < _count; i++)
                TurnLong();
        }

        /// <summary>
        /// A short rotation without a square root, and without a division that another has to wait for. M + M₊ has the length
        /// 2 |L| √(1 − ε), where 4 ε |L|² is |M₊ − M|², so r becomes a unit by a series in ε times a constant of the orbit.
        /// </summary>
        private void TurnShort()
        {
            TopShape s = _shape;
            double w1 = _w.X, w2 = _w.Y, w3 = _w.Z;

            // corrects the error at the start of the step, so that neither division waits for the other
            Wrong(w1, w2, w3, out double a, out double b, out double lambda);

            // the increment of w by Jacobi's addition theorem, so that small changes keep their digits
            double k = _kOfSquare * (w2 * w2), inverse = 1 / (1 - k);
            double d1 = (w1 * (k - _orbit.V1) + _s1 * (w2 * w3)) * inverse - w1 * a - b * (w1 * (s.G3 - lambda));
            double d2 = (w2 * (k - _v13) + _s2 * (w3 * w1)) * inverse - w2 * a + b * (w2 * lambda);
            double d3 = (w3 * (k - _orbit.V3) + _s3 * (w1 * w2)) * inverse - w3 * a + b * (w3 * (s.G1 + lambda));
            RunningSum.Add(ref _w.X, ref _wLost.X, d1);
            RunningSum.Add(ref _w.Y, ref _wLost.Y, d2);
            RunningSum.Add(ref _w.Z, ref _wLost.Z, d3);

            // h and m, half of M₊ − M and of M₊ + M: r ~ (c |m|²/L², c (h × m)/L² + m sin(ψ/2)/|L|), c = cos(ψ/2), |r|² ~ 1 − ε
            double h1 = 0.5 * s.I1 * d1, h2 = 0.5 * d2, h3 = 0.5 * s.I3 * d3;
            double m1 = s.I1 * w1 + h1, m2 = w2 + h2, m3 = s.I3 * w3 + h3;
            double r1 = _cosine * (h2 * m3 - h3 * m2) + _orbit.Sine * m1;
            double r2 = _cosine * (h3 * m1 - h1 * m3) + _orbit.Sine * m2;
            double r3 = _cosine * (h1 * m2 - h2 * m1) + _orbit.Sine * m3;

            // y = 1/√(1 − ε) − 1 by its series, and 1 − less = c (1 − ε): the scalar part is (1 − less)(1 + y); its difference to 1 is kept,
            // with half the error of |q|². The vector part becomes (1 + y) r, with the rounding error of Sine
            double e = (h1 * h1 + h2 * h2 + h3 * h3) * _orbit.InverseSquare, ee = e * e;
            double y = e * ((Y1 + e * Y2) + ee * (Y3 + e * Y4) + ee * ee * ((Y5 + e * Y6) + ee * (Y7 + e * Y8)));
            double more = y + _orbit.SineLost, v = _orbit.Versine, less = v + (e - v * e);
            double q0 = _q.W, q1 = _q.X, q2 = _q.Y, q3 = _q.Z;
            double r0 = (0.5 * (1 - (q0 * q0 + q1 * q1 + (q2 * q2 + q3 * q3))) - less + y) - less * y;

            // q₊ = q r; products with the vector part first, because the series comes last
            double t0 = q1 * r1 + q2 * r2 + q3 * r3, t1 = q0 * r1 + (q2 * r3 - q3 * r2);
            double t2 = q0 * r2 + (q3 * r1 - q1 * r3), t3 = q0 * r3 + (q1 * r2 - q2 * r1);
            RunningSum.Add(ref _q.W, ref _qLost.W, q0 * r0 - (t0 + more * t0));
            RunningSum.Add(ref _q.X, ref _qLost.X, q1 * r0 + (t1 + more * t1));
            RunningSum.Add(ref _q.Y, ref _qLost.Y, q2 * r0 + (t2 + more * t2));
            RunningSum.Add(ref _q.Z, ref _qLost.Z, q3 * r0 + (t3 + more * t3));
        }

        /// <summary>A rotation by any angle.</summary>
        private void TurnLong()
        {
            TopShape s = _shape;
            double w1 = _w.X, w2 = _w.Y, w3 = _w.Z, o = _orbit.S, c1 = _orbit.C1, c3 = _orbit.C3;

            // D as a sum of positive terms: 1 − k would cancel near the unstable axis
            double inverse = 1 / (c1 * c1 - s.K1 * s.K2 * (o * o) * (w3 * w3));
            double p1 = (w1 * c1 + s.K1 * (o * c3) * (w2 * w3)) * inverse;
            double p2 = (w2 * c1 * c3 + s.K2 * o * (w3 * w1)) * inverse;
            double p3 = (w3 * c3 + s.K3 * (o * c1) * (w1 * w2)) * inverse;

            Wrong(p1, p2, p3, out double a, out double b, out double lambda);
            Vector3d d = new Vector3d(
                (p1 - w1) - p1 * a - b * (p1 * (s.G3 - lambda)), (p2 - w2) - p2 * a + b * (p2 * lambda), (p3 - w3) - p3 * a + b * (p3 * (s.G1 + lambda)));
            RunningSum.Add(ref _w, ref _wLost, d);

            Vector3d h = new Vector3d(0.5 * s.I1 * d.X, 0.5 * d.Y, 0.5 * s.I3 * d.Z), before = new Vector3d(s.I1 * w1, w2, s.I3 * w3), m = before + h;
            double cosine = (1 - _orbit.Versine) * _orbit.InverseSquare, r0 = cosine * m.LengthSquared;
            Vector3d r = cosine * Vector3d.Cross(h, m) + _orbit.Sine * m;
            // for a rotation by more than half a revolution −r is nearer to 1 than r: it is used, and the sign corrected, so that q does not jump
            double vv = r.LengthSquared, sign = r0 < 0 ? -1 : 1, n = sign * Math.Sqrt(r0 * r0 + vv), f = 1 / (n * (n + r0)), v = f * (n + r0);
            Vector3d momentum = _q.Rotate(before);
            SmallTurn.Add(ref _q, ref _qLost, _q * new Quaterniond(-vv * f, v * r));
            _q = sign * _q;
            _qLost = sign * _qLost;

            // where M₊ is almost opposite to M, as after a flip, the smallest rotation between them is ill-conditioned, and L would
            // rotate by a rounding over |M + M₊|: it is rotated back
            Vector3d now = _q.Rotate(new Vector3d(s.I1 * _w.X, _w.Y, s.I3 * _w.Z)), back = 0.5 / now.LengthSquared * Vector3d.Cross(now, momentum);
            SmallTurn.Add(ref _q, ref _qLost, new Quaterniond(0, back) * _q);
        }

        /// <summary>
        /// The error of w: a scales it back to its energy, and b moves it along the gradient of Q back to Q, where lambda makes that
        /// gradient orthogonal to the scaling.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Wrong(double w1, double w2, double w3, out double a, out double b, out double lambda)
        {
            TopShape s = _shape;
            double w11 = w1 * w1, w33 = w3 * w3, x1 = s.M1 * w11, x3 = s.M3 * w33, x = x1 - x3, twice = x + x;
            a = _inverseEnergy * (s.I1 * w11 + s.I3 * w33 + (w2 * w2 - _energy));
            b = ((x - _separation) - twice * a) / (2 * (s.G3 * x1 + s.G1 * x3) + Tiny);
            lambda = _inverseEnergy * twice;
        }
    }
}
