#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>
    /// One rotation of each body of a block in two passes: each pass does so little per group that the processor works on several
    /// groups at the same time.
    /// </summary>
    internal partial struct AsymmetricLanes
    {
        // passed from the first pass to the second: ε, and the vector part of the rotation, which the series of ε scales to length 1
        private const int E = 0, R = 1;

        [MethodImpl(Kernel.Compiled)]
        private void TurnShort(in Block bodies)
        {
            Block passed = _left.From(0, bodies.Rows);
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                Spin(bodies.At(i), passed.At(i));

            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                Orient(bodies.At(i), passed.At(i));
        }

        /// <summary>The first pass computes w₊, and the rotation that belongs to it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Spin(in Group bodies, in Group left)
        {
            VectorLanes w = new VectorLanes(bodies, W), wLost = new VectorLanes(bodies, WLost);
            Lanes w1 = w.X, w2 = w.Y, w3 = w.Z, o = bodies[S], v1 = bodies[First], v3 = bodies[Third], one = Lanes.One;
            Wrong(bodies, w, out Lanes a, out Lanes b, out Lanes lambda);
            Lanes k = _k1k3 * (o * o) * (w2 * w2), inverse = one / (one - k);
            Lanes d1 = (w1 * (k - v1) + _k1 * (o * (one - v3)) * (w2 * w3)) * inverse - w1 * a - b * (w1 * (_g3 - lambda));
            Lanes d2 = (w2 * (k - (v1 + v3 - v1 * v3)) + _k2 * o * (w3 * w1)) * inverse - w2 * a + b * (w2 * lambda);
            Lanes d3 = (w3 * (k - v3) + _k3 * (o * (one - v1)) * (w1 * w2)) * inverse - w3 * a + b * (w3 * (_g1 + lambda));
            RunningSum.Add(ref w, ref wLost, new VectorLanes(d1, d2, d3));
            w.Write(bodies, W);
            wLost.Write(bodies, WLost);

            Lanes h1 = _half1 * d1, h2 = new Lanes(0.5) * d2, h3 = _half3 * d3, m1 = _i1 * w1 + h1, m2 = w2 + h2, m3 = _i3 * w3 + h3;
            Lanes inverseSquare = bodies[InverseSquare], cosine = (one - bodies[Versine]) * inverseSquare, sine = bodies[Sine];
            left[R] = cosine * (h2 * m3 - h3 * m2) + sine * m1;
            left[R + 1] = cosine * (h3 * m1 - h1 * m3) + sine * m2;
            left[R + 2] = cosine * (h1 * m2 - h2 * m1) + sine * m3;
            left[E] = (h1 * h1 + h2 * h2 + h3 * h3) * inverseSquare;
        }

        /// <summary>The second pass applies the rotation to q.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Orient(in Group bodies, in Group left)
        {
            Lanes e = left[E], ee = e * e, v = bodies[Versine], less = v + (e - v * e);
            Lanes y1 = new Lanes(AsymmetricTop.Y1) + e * new Lanes(AsymmetricTop.Y2), y3 = new Lanes(AsymmetricTop.Y3) + e * new Lanes(AsymmetricTop.Y4);
            Lanes y5 = new Lanes(AsymmetricTop.Y5) + e * new Lanes(AsymmetricTop.Y6), y7 = new Lanes(AsymmetricTop.Y7) + e * new Lanes(AsymmetricTop.Y8);
            Lanes y = e * (y1 + ee * y3 + ee * ee * (y5 + ee * y7)), more = y + bodies[SineLost];
            QuaternionLanes q = new QuaternionLanes(bodies, Q), qLost = new QuaternionLanes(bodies, QLost);
            Lanes q0 = q.W, q1 = q.X, q2 = q.Y, q3 = q.Z, r1 = left[R], r2 = left[R + 1], r3 = left[R + 2];
            Lanes r0 = (new Lanes(0.5) * (Lanes.One - (q0 * q0 + q1 * q1 + (q2 * q2 + q3 * q3))) - less + y) - less * y;
            Lanes t0 = q1 * r1 + q2 * r2 + q3 * r3, t1 = q0 * r1 + (q2 * r3 - q3 * r2);
            Lanes t2 = q0 * r2 + (q3 * r1 - q1 * r3), t3 = q0 * r3 + (q1 * r2 - q2 * r1);
            RunningSum.Add(ref q.W, ref qLost.W, q0 * r0 - (t0 + more * t0));
            RunningSum.Add(ref q.X, ref qLost.X, q1 * r0 + (t1 + more * t1));
            RunningSum.Add(ref q.Y, ref qLost.Y, q2 * r0 + (t2 + more * t2));
            RunningSum.Add(ref q.Z, ref qLost.Z, q3 * r0 + (t3 + more * t3));
            q.Write(bodies, Q);
            qLost.Write(bodies, QLost);
        }

        /// <summary>One rotation of each body of a group in which some rotations are long or absent.</summary>
        private void TurnAny(in Block few)
        {
            Group bodies = few.At(0);
            VectorLanes w = new VectorLanes(bodies, W), wLost = new VectorLanes(bodies, WLost), longW = w, longWLost = wLost;
            QuaternionLanes q = new QuaternionLanes(bodies, Q), qLost = new QuaternionLanes(bodies, QLost), longQ = q, longQLost = qLost;
            TurnLong(bodies, ref longW, ref longWLost, ref longQ, ref longQLost);
            if (Vector.GreaterThanAny(bodies[Turns], Lanes.Zero))
                TurnShort(few);

            Masks isShort = Vector.GreaterThan(bodies[Turns], Lanes.Zero), isLong = Vector.LessThan(bodies[Turns], Lanes.Zero);
            VectorLanes.Choose(isShort, new VectorLanes(bodies, W), VectorLanes.Choose(isLong, longW, w)).Write(bodies, W);
            VectorLanes.Choose(isShort, new VectorLanes(bodies, WLost), VectorLanes.Choose(isLong, longWLost, wLost)).Write(bodies, WLost);
            QuaternionLanes.Choose(isShort, new QuaternionLanes(bodies, Q), QuaternionLanes.Choose(isLong, longQ, q)).Write(bodies, Q);
            QuaternionLanes.Choose(isShort, new QuaternionLanes(bodies, QLost), QuaternionLanes.Choose(isLong, longQLost, qLost)).Write(bodies, QLost);
        }

        [MethodImpl(Kernel.Compiled)]
        private void TurnLong(in Group bodies, ref VectorLanes w, ref VectorLanes wLost, ref QuaternionLanes q, ref QuaternionLanes qLost)
        {
            Lanes w1 = w.X, w2 = w.Y, w3 = w.Z, o = bodies[S], c1 = bodies[First], c3 = bodies[Third], half = new Lanes(0.5), one = Lanes.One;
            VectorLanes p = one / (c1 * c1 - _k1k2 * (o * o) * (w3 * w3)) * new VectorLanes(
                w1 * c1 + _k1 * (o * c3) * (w2 * w3), w2 * c1 * c3 + _k2 * o * (w3 * w1), w3 * c3 + _k3 * (o * c1) * (w1 * w2));
            Wrong(bodies, p, out Lanes a, out Lanes b, out Lanes lambda);
            Lanes d1 = (p.X - w1) - p.X * a - b * (p.X * (_g3 - lambda));
            Lanes d2 = (p.Y - w2) - p.Y * a + b * (p.Y * lambda);
            Lanes d3 = (p.Z - w3) - p.Z * a + b * (p.Z * (_g1 + lambda));
            RunningSum.Add(ref w, ref wLost, new VectorLanes(d1, d2, d3));

            VectorLanes h = new VectorLanes(_half1 * d1, half * d2, _half3 * d3), before = new VectorLanes(_i1 * w1, w2, _i3 * w3), m = before + h;
            Lanes cosine = (one - bodies[Versine]) * bodies[InverseSquare], r0 = cosine * VectorLanes.Dot(m, m);
            VectorLanes r = cosine * VectorLanes.Cross(h, m) + bodies[Sine] * m, momentum = q.Rotate(before);
            Lanes vv = VectorLanes.Dot(r, r), sign = Vector.ConditionalSelect(Vector.LessThan(r0, Lanes.Zero), new Lanes(-1), one);
            Lanes n = sign * Vector.SquareRoot(r0 * r0 + vv), f = one / (n * (n + r0)), v = f * (n + r0);
            SmallTurn.Add(ref q, ref qLost, q * new QuaternionLanes(-vv * f, v * r));
            q = sign * q;
            qLost = sign * qLost;
            VectorLanes now = q.Rotate(new VectorLanes(_i1 * w.X, w.Y, _i3 * w.Z));
            VectorLanes back = half / VectorLanes.Dot(now, now) * VectorLanes.Cross(now, momentum);
            SmallTurn.Add(ref q, ref qLost, new QuaternionLanes(Lanes.Zero, back) * q);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Wrong(in Group bodies, in VectorLanes w, out Lanes a, out Lanes b, out Lanes lambda)
        {
            Lanes w11 = w.X * w.X, w33 = w.Z * w.Z, x1 = _m1 * w11, x3 = _m3 * w33, x = x1 - x3, twice = x + x, inverseEnergy = bodies[InverseEnergy];
            a = inverseEnergy * (_i1 * w11 + _i3 * w33 + (w.Y * w.Y - bodies[Energy]));
            b = ((x - bodies[Separation]) - twice * a) / (new Lanes(2) * (_g3 * x1 + _g1 * x3) + new Lanes(AsymmetricTop.Tiny));
            lambda = inverseEnergy * twice;
        }
    }
}
#endif
