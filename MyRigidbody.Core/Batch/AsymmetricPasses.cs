#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>
    /// One turn of each body of a block in two passes: in each there is so little to do for a group that the processor has several
    /// groups on the way at once.
    /// </summary>
    internal partial struct AsymmetricLanes
    {
        // what the second pass takes from the first: the turn r, M where it is wanted, and of a body at rest what it was
        private const int R0 = 0, M = 4, W0 = 7, WLost0 = 10;

        [MethodImpl(Kernel.Compiled)]
        private void TurnShort(in Block bodies) => Turn(bodies, areShort: true);

        /// <summary>Where not all turns are short, some of the bodies may be at rest.</summary>
        [MethodImpl(Kernel.Compiled)]
        private void TurnAny(in Block bodies) => Turn(bodies, areShort: false);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Turn(in Block bodies, bool areShort)
        {
            Block passed = _left.From(0, bodies.Rows);
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                Spin(bodies.At(i), passed.At(i), areShort);

            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                Orient(bodies.At(i), passed.At(i), areShort);
        }

        /// <summary>The first pass, over w: to w₊, and what that turns the body by.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Spin(in Group bodies, in Group left, bool areShort)
        {
            VectorLanes w = new VectorLanes(bodies, W), wLost = new VectorLanes(bodies, WLost);
            Lanes w1 = w.X, w2 = w.Y, w3 = w.Z, o = bodies[S], v1 = bodies[V1], v3 = bodies[V3], k1o = _k1 * o;
            Lanes oc1 = areShort ? Lanes.One - v1 : bodies[C1], oc3 = areShort ? Lanes.One - v3 : bodies[C3];
            Lanes k = _k1k3 * o * o * w2 * w2, inverse = Lanes.One / (Lanes.One - k);
            Lanes d1 = (w1 * (k - v1) + k1o * oc3 * w2 * w3) * inverse;
            Lanes d2 = (w2 * (k - (v1 + v3 - v1 * v3)) + _k2 * o * w3 * w1) * inverse;
            Lanes d3 = (w3 * (k - v3) + _k3 * o * oc1 * w1 * w2) * inverse;
            Lanes p1 = w1, p2 = w2, p3 = w3;
            if (!areShort)
            {
                Masks isShort = Vector.GreaterThan(bodies[Turns], Lanes.Zero);
                inverse = Lanes.One / (oc1 * oc1 - _k1k2 * o * o * w3 * w3);
                p1 = Vector.ConditionalSelect(isShort, w1, (w1 * oc1 + k1o * oc3 * w2 * w3) * inverse);
                p2 = Vector.ConditionalSelect(isShort, w2, (w2 * oc1 * oc3 + _k2 * o * w3 * w1) * inverse);
                p3 = Vector.ConditionalSelect(isShort, w3, (w3 * oc3 + _k3 * o * oc1 * w1 * w2) * inverse);
                d1 = Vector.ConditionalSelect(isShort, d1, p1 - w1);
                d2 = Vector.ConditionalSelect(isShort, d2, p2 - w2);
                d3 = Vector.ConditionalSelect(isShort, d3, p3 - w3);
                w.Write(left, W0);
                wLost.Write(left, WLost0);
            }

            Lanes half = new Lanes(0.5), two = new Lanes(2), inverseEnergy = bodies[InverseEnergy];
            Lanes a = inverseEnergy * (_i1 * p1 * p1 + p2 * p2 + _i3 * p3 * p3) - half;
            Lanes x1 = _m1 * p1 * p1, x3 = _m3 * p3 * p3, x = x1 - x3, lambda = two * inverseEnergy * x;
            Lanes b = (x - two * a * x - bodies[Separation]) / (two * (_g3 * x1 + _g1 * x3) + new Lanes(AsymmetricTop.Tiny));
            d1 -= p1 * (a + b * (_g3 - lambda));
            d2 -= p2 * (a - b * lambda);
            d3 -= p3 * (a - b * (_g1 + lambda));
            Change(ref w, ref wLost, d1, d2, d3);
            w.Write(bodies, W);
            wLost.Write(bodies, WLost);

            Lanes c = bodies[C], z = bodies[Z];
            Lanes m1 = _i1 * w1, m2 = w2, m3 = _i3 * w3, c1 = _i1 * d1, c2 = d2, c3 = _i3 * d3;
            Lanes s1 = two * m1 + c1, s2 = two * m2 + c2, s3 = two * m3 + c3;
            left[R0] = half * c * (s1 * s1 + s2 * s2 + s3 * s3);
            left[R0 + 1] = c * (c2 * m3 - c3 * m2) + z * s1;
            left[R0 + 2] = c * (c3 * m1 - c1 * m3) + z * s2;
            left[R0 + 3] = c * (c1 * m2 - c2 * m1) + z * s3;
            if (!areShort)
                new VectorLanes(m1, m2, m3).Write(left, M);
        }

        /// <summary>The second pass, over q.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Orient(in Group bodies, in Group left, bool areShort)
        {
            Lanes r0 = left[R0], r1 = left[R0 + 1], r2 = left[R0 + 2], r3 = left[R0 + 3];
            Lanes vv = r1 * r1 + r2 * r2 + r3 * r3, n = Vector.SquareRoot(r0 * r0 + vv);
            n = Vector.ConditionalSelect(Vector.LessThan(r0, Lanes.Zero), -n, n);
            Lanes f = Lanes.One / (n * (n + r0)), v = f * (n + r0);
            QuaternionLanes q = new QuaternionLanes(bodies, Q), qLost = new QuaternionLanes(bodies, QLost);
            VectorLanes momentum = areShort ? default(VectorLanes) : q.Rotate(new VectorLanes(left, M));
            SmallTurn.Add(ref q, ref qLost, q * new QuaternionLanes(-vv * f, v * r1, v * r2, v * r3));
            if (Vector.LessThanAny(r0, Lanes.Zero))
            {
                Lanes sign = Vector.ConditionalSelect(Vector.LessThan(r0, Lanes.Zero), new Lanes(-1), Lanes.One);
                q = sign * q;
                qLost = sign * qLost;
            }

            if (!areShort)
            {
                Masks isShort = Vector.GreaterThan(bodies[Turns], Lanes.Zero), isAtRest = Vector.Equals(bodies[Turns], Lanes.Zero);
                QuaternionLanes kept = q, keptLost = qLost;
                VectorLanes w = new VectorLanes(bodies, W), now = q.Rotate(new VectorLanes(_i1 * w.X, w.Y, _i3 * w.Z));
                VectorLanes back = new Lanes(0.5) / VectorLanes.Dot(now, now) * VectorLanes.Cross(now, momentum);
                SmallTurn.Add(ref kept, ref keptLost, new QuaternionLanes(Lanes.Zero, back) * q);
                q = QuaternionLanes.Choose(isShort, q, kept);
                qLost = QuaternionLanes.Choose(isShort, qLost, keptLost);
                q = QuaternionLanes.Choose(isAtRest, new QuaternionLanes(bodies, Q), q);
                qLost = QuaternionLanes.Choose(isAtRest, new QuaternionLanes(bodies, QLost), qLost);
                VectorLanes.Choose(isAtRest, new VectorLanes(left, W0), w).Write(bodies, W);
                VectorLanes.Choose(isAtRest, new VectorLanes(left, WLost0), new VectorLanes(bodies, WLost)).Write(bodies, WLost);
            }

            q.Write(bodies, Q);
            qLost.Write(bodies, QLost);
        }
    }
}
#endif
