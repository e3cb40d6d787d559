#if NET
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;
using Vector = System.Numerics.Vector;

namespace RigidBodyDynamics
{
    internal partial struct SphericalTop : IHasLanes
    {
        public Crowd InLanes<TScheme>(BodyDescription body) where TScheme : struct, IScheme =>
            new Composition<SphericalTop, TScheme>.InColumns<SphericalTop, SphericalLanes>(body);

        public void Carry(Row row, bool isAll)
        {
            row.Carry(SphericalLanes.Q, ref _q);
            row.Carry(SphericalLanes.W, ref _w);
            if (!isAll)
                return;

            row.Carry(SphericalLanes.QLost, ref _qLost);
            row.Carry(SphericalLanes.WLost, ref _wLost);
            row.Carry(SphericalLanes.Turn, ref _turn);
            row.Carry(SphericalLanes.PreparedFor, ref _preparedFor);
        }
    }

    /// <summary>The step of <see cref="SphericalTop"/> for several bodies at once: the same operations in the same order.</summary>
    internal struct SphericalLanes : ITopLanes
    {
        public const int Q = CompositionLanes.Columns, QLost = Q + 4, Turn = QLost + 4, W = Turn + 4, WLost = W + 3, PreparedFor = W + 6;

        private double _inverseMoment;

        public int Columns => PreparedFor + 1;

        public void Start(MassProperties mass) => _inverseMoment = mass.InversePrincipalMoments.X;

        public Vector3d FromBody(Vector3d v) => v;

        public Vector3d FromWorld(Vector3d v) => v;

        public void Kick(in Group bodies, in SharedImpulse impulse)
        {
            VectorLanes change = new VectorLanes(impulse.World);
            if (impulse.HasBody)
                change += new QuaternionLanes(bodies, Q).Rotate(new VectorLanes(impulse.Body));

            VectorLanes w = new VectorLanes(bodies, W), lost = new VectorLanes(bodies, WLost);
            RunningSum.Add(ref w, ref lost, _inverseMoment * change);
            w.Write(bodies, W);
            lost.Write(bodies, WLost);
            bodies[PreparedFor] = new Lanes(double.NaN);
        }

        public void Damp(in Group bodies, in Decay decay)
        {
            if (decay.IsNone)
                return;

            VectorLanes w = new VectorLanes(bodies, W), lost = new VectorLanes(bodies, WLost);
            decay.Take(ref w, ref lost);
            w.Write(bodies, W);
            lost.Write(bodies, WLost);
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
                SmallTurn.Add(ref q, ref lost, new QuaternionLanes(group, Turn) * q);
                q.Write(group, Q);
                lost.Write(group, QLost);
            }
        }

        public void Show(in Group bodies, out QuaternionLanes orientation, out VectorLanes angularVelocity)
        {
            orientation = new QuaternionLanes(bodies, Q);
            angularVelocity = new VectorLanes(bodies, W);
        }

        /// <summary>Prepares all bodies: a rotation that is prepared already gets the same bits.</summary>
        private static void Prepare(in Group bodies, double time)
        {
            VectorLanes w = new VectorLanes(bodies, W);
            SmallTurn.Of(w, Vector.SquareRoot(VectorLanes.Dot(w, w)), time).Write(bodies, Turn);
            bodies[PreparedFor] = new Lanes(time);
        }
    }
}
#endif
