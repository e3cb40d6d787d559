#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The step of <see cref="AsymmetricTop"/> for several bodies at once: the same operations in the same order, so that each body
    /// gets the same bits. A body whose step needs more than one rotation is rotated alone, by its own integrator.
    /// </summary>
    internal partial struct AsymmetricLanes : ITopLanes
    {
        public const int Q = CompositionLanes.Columns, QLost = Q + 4, W = QLost + 4, WLost = W + 3;
        public const int Energy = WLost + 3, Separation = Energy + 1, Scale = Energy + 2, PreparedFor = Energy + 3;
        public const int InverseEnergy = Energy + 4, S = InverseEnergy + 1;

        /// <summary>1 − c₁ and 1 − c₃; c₁ and c₃ themselves where the rotation is not short.</summary>
        public const int First = S + 1, Third = S + 2;

        public const int InverseSquare = S + 3, Sine = S + 4, SineLost = S + 5, Versine = S + 6;

        /// <summary>The number of rotations in a step; negative where they are not short.</summary>
        public const int Turns = S + 7;

        private AsymmetricTop _one;
        private TopShape _shape;
        private Lanes _i1, _i3, _half1, _half3, _k1, _k2, _k3, _k1k2, _k1k3, _g1, _g3, _m1, _m3;
        // state that one pass over a block leaves to the next
        private Columns _left;

        public int Columns => Turns + 1;

        public void Start(MassProperties mass)
        {
            _one.Start(mass, Quaterniondd.Unit(Quaterniond.Identity), Vector3d.Zero);
            _shape = mass.Shape;
            _i1 = new Lanes(_shape.I1);
            _i3 = new Lanes(_shape.I3);
            _half1 = new Lanes(0.5 * _shape.I1);
            _half3 = new Lanes(0.5 * _shape.I3);
            _k1 = new Lanes(_shape.K1);
            _k2 = new Lanes(_shape.K2);
            _k3 = new Lanes(_shape.K3);
            _k1k2 = new Lanes(_shape.K1 * _shape.K2);
            _k1k3 = new Lanes(_shape.K1 * _shape.K3);
            _g1 = new Lanes(_shape.G1);
            _g3 = new Lanes(_shape.G3);
            _m1 = new Lanes(_shape.M1);
            _m3 = new Lanes(_shape.M3);
            _left = new Columns(R + 4);
            _left.Reserve(RigidBodyDynamics.Columns.RowsOfBlock);
        }

        public Vector3d FromBody(Vector3d v) => _shape.Axes.FromBody(v);

        public Vector3d FromWorld(Vector3d v) => _shape.Axes.FromWorld(v);

        public void Kick(in Group bodies, in SharedImpulse impulse)
        {
            VectorLanes w = new VectorLanes(bodies, W), lost = new VectorLanes(bodies, WLost);
            VectorLanes j = new VectorLanes(Vector3d.Zero);
            if (impulse.HasWorld)
                j = new QuaternionLanes(bodies, Q).RotateInverse(new VectorLanes(impulse.World));

            if (impulse.HasBody)
                j += new VectorLanes(impulse.Body);

            j = Lanes.One / bodies[Scale] * j;
            Vector3d inverse = _shape.InverseMoments;
            Lanes two = new Lanes(2);
            Lanes d1 = new Lanes(inverse.X) * j.X, d2 = new Lanes(inverse.Y) * j.Y, d3 = new Lanes(inverse.Z) * j.Z;
            Lanes e1 = (two * w.X + d1) * d1, e2 = (two * w.Y + d2) * d2, e3 = (two * w.Z + d3) * d3;
            bodies[Energy] += _i1 * e1 + e2 + _i3 * e3;
            bodies[Separation] += _m1 * e1 - _m3 * e3;
            RunningSum.Add(ref w, ref lost, new VectorLanes(d1, d2, d3));
            w.Write(bodies, W);
            lost.Write(bodies, WLost);
            bodies[PreparedFor] = new Lanes(double.NaN);
        }

        public void Damp(in Group bodies, in Decay decay)
        {
            if (decay.IsNone)
                return;

            Lanes scale = decay.Of(bodies[Scale]);
            bodies[Scale] = scale;
            bodies[PreparedFor] = new Lanes(double.NaN);
            Masks small = Vector.LessThan(scale, new Lanes(AsymmetricTop.LeastScale));
            if (Vector.LessThanAny(scale, new Lanes(AsymmetricTop.LeastScale)))
                Fold(bodies, small);
        }

        public void Advance(in Block bodies, double time)
        {
            if (bodies.ReadyFor == time || Prepare(bodies, time))
            {
                TurnShort(bodies);
                return;
            }

            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
            {
                Block few = bodies.Part(i, Lanes.Count);
                Group group = few.At(0);
                if (Vector.EqualsAll(group[Turns], Lanes.One))
                    TurnShort(few);
                else if (Vector.LessThanOrEqualAll(Vector.Abs(group[Turns]), Lanes.One))
                    TurnAny(few);
                else
                    TurnOneByOne(group);
            }
        }

        public void Show(in Group bodies, out QuaternionLanes orientation, out VectorLanes angularVelocity)
        {
            LongTurnLanes q = new LongTurnLanes(bodies, Q, QLost);
            LongLanes scale = new LongLanes(bodies[Scale], Lanes.Zero), x = scale * new LongLanes(bodies[W], bodies[WLost]);
            LongLanes y = scale * new LongLanes(bodies[W + 1], bodies[WLost + 1]), z = scale * new LongLanes(bodies[W + 2], bodies[WLost + 2]);
            q.Rotate(ref x, ref y, ref z);
            angularVelocity = _shape.Axes.ToWorld(new VectorLanes(x.High, y.High, z.High));
            _shape.Axes.ToBody(ref q);
            orientation = q.Rounded;
        }

        /// <summary>Prepares the bodies that need it. True if every body makes one short rotation.</summary>
        private bool Prepare(in Block bodies, double time)
        {
            bool areShort = true, areKept = bodies.IsWhole;
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
            {
                Group group = bodies.At(i);
                Lanes scaled = new Lanes(time) * group[Scale];
                if (!Vector.EqualsAll(scaled, group[PreparedFor]))
                    Prepare(group, scaled, time);

                areShort &= Vector.EqualsAll(group[Turns], Lanes.One);
                areKept &= Vector.EqualsAll(scaled, group[PreparedFor]);
            }

            // what holds for a part of a block need not hold for the whole
            if (areShort && areKept)
                bodies.ReadyFor = time;

            return areShort;
        }

        /// <summary>Prepares the bodies whose constants belong to another step length.</summary>
        private void Prepare(in Group bodies, Lanes scaled, double time)
        {
            VectorLanes w = new VectorLanes(bodies, W);
            Lanes w11 = w.X * w.X, w22 = w.Y * w.Y, w33 = w.Z * w.Z, same = new Lanes(AsymmetricTop.SameInvariant);
            Lanes energy = _i1 * w11 + w22 + _i3 * w33, separation = _m1 * w11 - _m3 * w33;
            Lanes a1 = _i1 * w11 + _g1 * w22, a3 = _i3 * w33 + _g3 * w22;
            Lanes held = bodies[Energy], heldSeparation = bodies[Separation];
            held = Vector.ConditionalSelect(Vector.LessThanOrEqual(Vector.Abs(held - energy), same * energy), held, energy);
            heldSeparation = Vector.ConditionalSelect(
                Vector.LessThanOrEqual(Vector.Abs(heldSeparation - separation), same * (_g3 * a1 + _g1 * a3)), heldSeparation, separation);

            Masks isOther = ~Vector.Equals(scaled, bodies[PreparedFor]), isKept = Vector.Equals(bodies[PreparedFor], new Lanes(AsymmetricTop.ForOneStep));
            Masks isTurning = isOther & Vector.GreaterThan(held, new Lanes(AsymmetricTop.Resting))
                & Vector.GreaterThan(held * scaled * scaled, new Lanes(AsymmetricTop.NoTurn));
            OrbitLanes orbit = default(OrbitLanes);
            Lanes rate = Vector.Max(_shape.AlphaOfA3 * a3, _shape.BetaOfA1 * a1);
            Lanes turned = held * held * (scaled * scaled), momentum = _i1 * a1 + _i3 * a3;
            Masks isFar = Vector.GreaterThan(turned, new Lanes(AsymmetricTop.OrdinarySquared) * momentum)
                & Vector.LessThan(turned, new Lanes(AsymmetricTop.LostSquared) * momentum);
            Masks isOneByOne = isTurning & (isKept | isFar);
            if (!Vector.EqualsAll(isTurning & ~isOneByOne, Masks.Zero))
            {
                // more than one rotation is prepared body by body, from the present state, and so is what is stored
                const double Longest = AsymmetricTop.LongestNearUnstable * AsymmetricTop.LongestNearUnstable;
                orbit.Set(_shape, a1, a3, heldSeparation, scaled);
                isOneByOne |= isTurning & (orbit.IsIllConditioned | (Vector.LessThan(Vector.Abs(_shape.DeltaOfQ * heldSeparation), 0.01 * rate)
                    & Vector.GreaterThan(rate * scaled * scaled, new Lanes(Longest))));
            }

            Masks isShort = Vector.LessThanOrEqual(rate * orbit.S * orbit.S, new Lanes(AsymmetricTop.ShortSquared))
                & Vector.GreaterThan(orbit.C1, Lanes.Zero) & Vector.GreaterThan(orbit.C3, Lanes.Zero)
                & Vector.LessThanOrEqual(orbit.Versine, new Lanes(AsymmetricTop.LargestVersine)), isHere = isOther & ~isOneByOne;
            Set(ref bodies[Energy], isHere, held);
            Set(ref bodies[Separation], isHere, heldSeparation);
            Set(ref bodies[PreparedFor], isHere, Vector.ConditionalSelect(isKept, scaled, new Lanes(AsymmetricTop.ForOneStep)));
            Set(ref bodies[Turns], isHere, Vector.ConditionalSelect(isTurning, Vector.ConditionalSelect(isShort, Lanes.One, -Lanes.One), Lanes.Zero));
            Set(ref bodies[InverseEnergy], isHere, new Lanes(0.5) / held);
            Set(ref bodies[S], isHere, orbit.S);
            Set(ref bodies[First], isHere, Vector.ConditionalSelect(isShort, orbit.V1, orbit.C1));
            Set(ref bodies[Third], isHere, Vector.ConditionalSelect(isShort, orbit.V3, orbit.C3));
            Set(ref bodies[InverseSquare], isHere, orbit.InverseSquare);
            Set(ref bodies[Sine], isHere, orbit.Sine);
            Set(ref bodies[SineLost], isHere, Lanes.Zero);
            Set(ref bodies[Versine], isHere, orbit.Versine);
            if (!Vector.EqualsAll(isOneByOne, Masks.Zero))
                PrepareOneByOne(bodies, isOneByOne, time);
        }

        private void PrepareOneByOne(in Group bodies, Masks which, double time)
        {
            for (int i = 0; i < Lanes.Count; i++)
            {
                if (which[i] == 0)
                    continue;

                AsymmetricTop one = _one;
                one.Carry(bodies.Row(i, isOut: false), isAll: true);
                one.Prepare(time * bodies[Scale][i]);
                one.Carry(bodies.Row(i, isOut: true), isAll: true);
            }
        }

        private void TurnOneByOne(in Group bodies)
        {
            for (int i = 0; i < Lanes.Count; i++)
            {
                AsymmetricTop one = _one;
                one.Carry(bodies.Row(i, isOut: false), isAll: true);
                one.Turn();
                one.Carry(bodies.Row(i, isOut: true), isAll: true);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Set(ref Lanes number, Masks where, Lanes value) => number = Vector.ConditionalSelect(where, value, number);

        /// <summary>Multiplies the damping, where requested, into the angular velocity itself.</summary>
        private static void Fold(in Group bodies, Masks where)
        {
            Lanes scale = bodies[Scale], one = Lanes.One;
            Lanes left = Vector.ConditionalSelect(Vector.GreaterThan(bodies[Energy] * (scale * scale), new Lanes(AsymmetricTop.Resting)), scale, Lanes.Zero);
            // a factor of one changes no bits
            left = Vector.ConditionalSelect(where, left, one);
            (left * new VectorLanes(bodies, W)).Write(bodies, W);
            (left * new VectorLanes(bodies, WLost)).Write(bodies, WLost);
            bodies[Energy] *= left * left;
            bodies[Separation] *= left * left;
            bodies[Scale] = Vector.ConditionalSelect(where, Lanes.One, bodies[Scale]);
            bodies[PreparedFor] = Vector.ConditionalSelect(where, new Lanes(double.NaN), bodies[PreparedFor]);
        }
    }
}
#endif
