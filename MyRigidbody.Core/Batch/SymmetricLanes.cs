#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    internal partial struct SymmetricTop : IHasLanes
    {
        internal PrincipalAxesOrder Axes => _axes;

        internal double Across => _across;

        internal double Along => _along;

        internal double Slip => _slip;

        public Crowd InLanes<TScheme>(BodyDescription body) where TScheme : struct, IScheme =>
            new Composition<SymmetricTop, TScheme>.InColumns<SymmetricTop, SymmetricLanes>(body);

        public void Carry(Row row, bool isAll)
        {
            row.Carry(SymmetricLanes.Q, ref _q);
            row.Carry(SymmetricLanes.QLost, ref _qLost);
            row.Carry(SymmetricLanes.Momentum, ref _momentum);
            row.Carry(SymmetricLanes.W3, ref _w3);
            if (!isAll)
                return;

            row.Carry(SymmetricLanes.MomentumLost, ref _momentumLost);
            row.Carry(SymmetricLanes.W3Lost, ref _w3Lost);
            row.Carry(SymmetricLanes.Turn, ref _turn);
            row.Carry(SymmetricLanes.SpinW, ref _spinW);
            row.Carry(SymmetricLanes.SpinZ, ref _spinZ);
            row.Carry(SymmetricLanes.PreparedFor, ref _preparedFor);
        }
    }

    /// <summary>The step of <see cref="SymmetricTop"/> for several bodies at once: the same operations in the same order.</summary>
    internal struct SymmetricLanes : ITopLanes
    {
        public const int Q = CompositionLanes.Columns, QLost = Q + 4, Turn = QLost + 4, Momentum = Turn + 4;
        public const int W3 = Momentum + 3, SpinW = W3 + 1, SpinZ = W3 + 2, PreparedFor = W3 + 3, MomentumLost = W3 + 4, W3Lost = W3 + 7;

        private PrincipalAxesOrder _axes;
        private double _across, _along, _slip;

        public int Columns => W3Lost + 1;

        public void Start(MassProperties mass)
        {
            SymmetricTop one = default(SymmetricTop);
            one.Start(mass, Quaterniondd.Unit(Quaterniond.Identity), Vector3d.Zero);
            _axes = one.Axes;
            _across = one.Across;
            _along = one.Along;
            _slip = one.Slip;
        }

        public Vector3d FromBody(Vector3d v) => _axes.FromBody(v);

        public Vector3d FromWorld(Vector3d v) => _axes.FromWorld(v);

        public void Kick(in Group bodies, in SharedImpulse impulse)
        {
            QuaternionLanes q = new QuaternionLanes(bodies, Q);
            VectorLanes world = new VectorLanes(impulse.World), body = new VectorLanes(impulse.Body);
            Lanes along = impulse.HasWorld ? q.RotateInverse(world).Z : Lanes.Zero;
            RunningSum.Add(ref bodies[W3], ref bodies[W3Lost], (body.Z + along) / new Lanes(_along));
            VectorLanes momentum = new VectorLanes(bodies, Momentum), lost = new VectorLanes(bodies, MomentumLost);
            RunningSum.Add(ref momentum, ref lost, impulse.HasBody ? world + q.Rotate(body) : world);
            momentum.Write(bodies, Momentum);
            lost.Write(bodies, MomentumLost);
            bodies[PreparedFor] = new Lanes(double.NaN);
        }

        public void Damp(in Group bodies, in Decay decay)
        {
            if (decay.IsNone)
                return;

            decay.Take(ref bodies[W3], ref bodies[W3Lost]);
            VectorLanes momentum = new VectorLanes(bodies, Momentum), lost = new VectorLanes(bodies, MomentumLost);
            decay.Take(ref momentum, ref lost);
            momentum.Write(bodies, Momentum);
            lost.Write(bodies, MomentumLost);
            bodies[PreparedFor] = new Lanes(double.NaN);
        }

        [MethodImpl(Kernel.Compiled)]
        public void Advance(in Block bodies, double time)
        {
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
            {
                Group group = bodies.At(i);
                if (!Vector.EqualsAll(new Lanes(time), group[PreparedFor]))
                    Prepare(group, time);

                QuaternionLanes q = new QuaternionLanes(group, Q), lost = new QuaternionLanes(group, QLost);
                QuaternionLanes d = new QuaternionLanes(group, Turn) * q, p = q + d;
                Lanes w = group[SpinW], z = group[SpinZ];
                SmallTurn.Add(ref q, ref lost, new QuaternionLanes(
                    d.W + p.W * w - p.Z * z,
                    d.X + p.X * w + p.Y * z,
                    d.Y + p.Y * w - p.X * z,
                    d.Z + p.Z * w + p.W * z));
                q.Write(group, Q);
                lost.Write(group, QLost);
            }
        }

        public void Show(in Group bodies, out QuaternionLanes orientation, out VectorLanes angularVelocity)
        {
            LongTurnLanes q = new LongTurnLanes(bodies, Q, QLost);
            VectorLanes momentum = new VectorLanes(bodies, Momentum);
            LongLanes x = 0, y = 0, z = (LongLanes)_slip * new LongLanes(bodies[W3], Lanes.Zero), turn = 1 / (DoubleDouble)_across;
            q.Rotate(ref x, ref y, ref z);
            x = turn * new LongLanes(momentum.X, Lanes.Zero) + x;
            y = turn * new LongLanes(momentum.Y, Lanes.Zero) + y;
            z = turn * new LongLanes(momentum.Z, Lanes.Zero) + z;
            angularVelocity = _axes.ToWorld(new VectorLanes(x.High, y.High, z.High));
            _axes.ToBody(ref q);
            orientation = q.Rounded;
        }

        /// <summary>Prepares all bodies: constants that are prepared already get the same bits.</summary>
        private void Prepare(in Group bodies, double time)
        {
            VectorLanes rate = 1 / _across * new VectorLanes(bodies, Momentum);
            SmallTurn.Of(rate, Vector.SquareRoot(VectorLanes.Dot(rate, rate)), time).Write(bodies, Turn);
            Lanes slip = _slip * bodies[W3];
            QuaternionLanes spin = SmallTurn.Of(new VectorLanes(Lanes.Zero, Lanes.Zero, slip), Vector.Abs(slip), time);
            bodies[SpinW] = spin.W;
            bodies[SpinZ] = spin.Z;
            bodies[PreparedFor] = new Lanes(time);
        }
    }
}
#endif
