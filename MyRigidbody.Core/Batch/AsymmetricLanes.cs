#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Masks = System.Numerics.Vector<long>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The step of <see cref="AsymmetricTop"/> for several bodies at once: its operations in its order, so that each body
    /// comes to the same bits. Where a body wants more than one turn, it alone is turned by its own rule.
    /// </summary>
    internal partial struct AsymmetricLanes : ITopLanes
    {
        public const int Q = CompositionLanes.Columns, QLost = Q + 4, W = QLost + 4, WLost = W + 3;
        public const int Energy = WLost + 3, Separation = Energy + 1, Scale = Energy + 2, PreparedFor = Energy + 3;
        public const int InverseEnergy = Energy + 4, S = InverseEnergy + 1, C1 = S + 1, C3 = S + 2, V1 = S + 3, V3 = S + 4, C = S + 5, Z = S + 6;

        /// <summary>How many turns a step takes; negative where they are not short.</summary>
        public const int Turns = S + 7;

        private AsymmetricTop _one;
        private TopShape _shape;
        private Lanes _i1, _i3, _k1, _k2, _k3, _k1k2, _k1k3, _g1, _g3, _m1, _m3;
        // what one pass over a block leaves to the next
        private Columns _left;

        public int Columns => Turns + 1;

        public void Start(MassProperties mass)
        {
            _one.Start(mass, Quaterniondd.Unit(Quaterniond.Identity), Vector3d.Zero);
            _shape = mass.Shape;
            _i1 = new Lanes(_shape.I1);
            _i3 = new Lanes(_shape.I3);
            _k1 = new Lanes(_shape.K1);
            _k2 = new Lanes(_shape.K2);
            _k3 = new Lanes(_shape.K3);
            _k1k2 = new Lanes(_shape.K1 * _shape.K2);
            _k1k3 = new Lanes(_shape.K1 * _shape.K3);
            _g1 = new Lanes(_shape.G1);
            _g3 = new Lanes(_shape.G3);
            _m1 = new Lanes(_shape.M1);
            _m3 = new Lanes(_shape.M3);
            _left = new Columns(WLost0 + 3);
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
            Change(ref w, ref lost, d1, d2, d3);
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
                if (AreShort(group))
                    TurnShort(few);
                else if (Vector.LessThanOrEqualAll(Vector.Abs(group[Turns]), Lanes.One))
                    TurnAny(few);
                else
                    TurnOneByOne(group, time);
            }
        }

        /// <summary>Prepares where that is wanted. True if all bodies are to make one short turn.</summary>
        private bool Prepare(in Block bodies, double time)
        {
            bool areShort = true;
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
            {
                Group group = bodies.At(i);
                Lanes scaled = new Lanes(time) * group[Scale];
                if (!Vector.EqualsAll(scaled, group[PreparedFor]))
                    Prepare(group, scaled, time);

                areShort &= AreShort(group);
            }

            // a part of a block can say nothing about all of it
            if (areShort && bodies.IsWhole)
                bodies.ReadyFor = time;

            return areShort;
        }

        /// <summary>True if each makes one short turn, whose C is what is left of 1 by V.</summary>
        private static bool AreShort(in Group bodies) => Vector.EqualsAll(bodies[Turns], Lanes.One)
            && Vector.EqualsAll(bodies[C1], Lanes.One - bodies[V1]) && Vector.EqualsAll(bodies[C3], Lanes.One - bodies[V3]);

        /// <summary>Prepares those that are prepared for another time.</summary>
        private void Prepare(in Group bodies, Lanes scaled, double time)
        {
            VectorLanes w = new VectorLanes(bodies, W);
            Lanes energy = _i1 * w.X * w.X + w.Y * w.Y + _i3 * w.Z * w.Z, separation = _m1 * w.X * w.X - _m3 * w.Z * w.Z;
            Lanes a1 = _i1 * w.X * w.X + _g1 * w.Y * w.Y, a3 = _i3 * w.Z * w.Z + _g3 * w.Y * w.Y, same = new Lanes(AsymmetricTop.SameInvariant);
            Lanes held = bodies[Energy], heldSeparation = bodies[Separation];
            held = Vector.ConditionalSelect(Vector.LessThanOrEqual(Vector.Abs(held - energy), same * energy), held, energy);
            heldSeparation = Vector.ConditionalSelect(
                Vector.LessThanOrEqual(Vector.Abs(heldSeparation - separation), same * (_g3 * a1 + _g1 * a3)), heldSeparation, separation);

            Masks isOther = ~Vector.Equals(scaled, bodies[PreparedFor]);
            Masks isTurning = isOther & Vector.GreaterThan(held, new Lanes(AsymmetricTop.Resting))
                & Vector.GreaterThan(held * scaled * scaled, new Lanes(AsymmetricTop.NoTurn));
            OrbitLanes orbit = default(OrbitLanes);
            Lanes rate = Vector.Max(_shape.AlphaOfA3 * a3, _shape.BetaOfA1 * a1);
            Masks isOneByOne = Masks.Zero;
            if (!Vector.EqualsAll(isTurning, Masks.Zero))
            {
                // more than one turn is prepared for one by one, from what is there now
                const double Longest = AsymmetricTop.LongestNearUnstable * AsymmetricTop.LongestNearUnstable;
                orbit.Set(_shape, a1, a3, heldSeparation, scaled);
                isOneByOne = Vector.LessThan(Vector.Abs(_shape.DeltaOfQ * heldSeparation), 0.01 * rate)
                    & Vector.GreaterThan(rate * scaled * scaled, new Lanes(Longest));
                isOneByOne = isTurning & (isOneByOne | orbit.IsIllConditioned);
            }

            Masks isShort = Vector.LessThanOrEqual(rate * orbit.S * orbit.S, new Lanes(AsymmetricTop.ShortSquared))
                & Vector.GreaterThan(orbit.C1, Lanes.Zero) & Vector.GreaterThan(orbit.C3, Lanes.Zero), isHere = isOther & ~isOneByOne;
            Set(ref bodies[Energy], isHere, held);
            Set(ref bodies[Separation], isHere, heldSeparation);
            Set(ref bodies[PreparedFor], isHere, scaled);
            Set(ref bodies[Turns], isHere, Vector.ConditionalSelect(isTurning, Vector.ConditionalSelect(isShort, Lanes.One, -Lanes.One), Lanes.Zero));
            Set(ref bodies[InverseEnergy], isHere, new Lanes(0.5) / held);
            Set(ref bodies[S], isHere, orbit.S);
            Set(ref bodies[C1], isHere, orbit.C1);
            Set(ref bodies[C3], isHere, orbit.C3);
            Set(ref bodies[V1], isHere, orbit.V1);
            Set(ref bodies[V3], isHere, orbit.V3);
            Set(ref bodies[C], isHere, orbit.C);
            Set(ref bodies[Z], isHere, orbit.Z);
            if (!Vector.EqualsAll(isOneByOne, Masks.Zero))
                PrepareOneByOne(bodies, time);
        }

        private void PrepareOneByOne(in Group bodies, double time)
        {
            for (int i = 0; i < Lanes.Count; i++)
            {
                AsymmetricTop one = _one;
                one.Carry(bodies.Row(i, isOut: false), isAll: true);
                one.PrepareFor(time);
                one.Carry(bodies.Row(i, isOut: true), isAll: true);
            }
        }

        private void TurnOneByOne(in Group bodies, double time)
        {
            for (int i = 0; i < Lanes.Count; i++)
            {
                AsymmetricTop one = _one;
                one.Carry(bodies.Row(i, isOut: false), isAll: true);
                one.Advance(time);
                one.Carry(bodies.Row(i, isOut: true), isAll: true);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Set(ref Lanes number, Masks where, Lanes value) => number = Vector.ConditionalSelect(where, value, number);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Change(ref VectorLanes w, ref VectorLanes lost, Lanes d1, Lanes d2, Lanes d3)
        {
            RunningSum.Add(ref w.X, ref lost.X, d1);
            RunningSum.Add(ref w.Y, ref lost.Y, d2);
            RunningSum.Add(ref w.Z, ref lost.Z, d3);
        }

        /// <summary>Where asked for, takes the damping into the angular velocity itself.</summary>
        private static void Fold(in Group bodies, Masks where)
        {
            Lanes scale = bodies[Scale], one = Lanes.One;
            Lanes left = Vector.ConditionalSelect(Vector.GreaterThan(bodies[Energy] * (scale * scale), new Lanes(AsymmetricTop.Resting)), scale, Lanes.Zero);
            // times one changes nothing
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
