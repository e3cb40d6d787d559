#if NET
using System;
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    internal partial struct LabEuler : IRuleInLanes
    {
        Crowd IRuleInLanes.InLanes(BodyDescription body) => body.Lab.FirstOrderOrientation ? new LabCrowd(body) : null;

        private sealed class LabCrowd : LaneCrowd<LabEuler, LabLanes>
        {
            public LabCrowd(BodyDescription body) : base(body, new LabLanes(new Columns(LabLanes.Count))) { }

            protected override void Carry(ref LabEuler body, Row row, bool isAll)
            {
                row.Carry(LabLanes.X, ref body._body.Position);
                row.Carry(LabLanes.Q, ref body._body.Orientation);
                row.Carry(LabLanes.V, ref body._body.Velocity);
                row.Carry(LabLanes.W, ref body._body.AngularVelocity);
            }
        }
    }

    /// <summary>The five steps of <see cref="LabEuler"/> for several bodies at once, under a load that is the same for all.</summary>
    internal struct LabLanes : ILaneRule
    {
        public const int X = 0, Q = 3, V = 7, W = 10, Count = 13;

        private MassProperties _mass;
        private LabSettings _lab;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt, _linearDecay, _angularDecay;
        private Vector3d _gravity;
        private int _from, _to;

        public LabLanes(Columns bodies) : this() => Bodies = bodies;

        public Columns Bodies { get; }

        public BodyState State => throw new NotSupportedException();

        public bool IsAsleep => false;

        public bool IsFinite => true;

        public bool HasClosedForm => false;

        public void Start(in Beginning body)
        {
            _mass = body.Mass;
            _lab = body.Lab;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !body.Mass.CenterOfMass.IsZero;
        }

        public void Push(in Wrench impulse) => throw new NotSupportedException();

        public void Select(int from, int to)
        {
            _from = from;
            _to = to;
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _gravity = coasting.Acceleration;
            _linearDecay = coasting.LinearDecay(duration);
            _angularDecay = coasting.AngularDecay(duration);
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            Wrench load = default(Wrench);
            BodyState unread = default(BodyState);
            push.At(now, unread, _mass, ref load);
            bool isTurned = _canTurn && (push.Traits & EffectTraits.Turns) != 0;
            for (int i = _from, end; i < _to; i = end)
                Run(Bodies.From(i, end = Math.Min(_to, Columns.EndOfBlock(i))), load, isTurned);
        }

        public void Show(in Group bodies, out GroupState seen)
        {
            seen.Position = new VectorLanes(bodies, X);
            seen.Orientation = new QuaternionLanes(bodies, Q);
            seen.Velocity = new VectorLanes(bodies, V);
            seen.AngularVelocity = new VectorLanes(bodies, W);
        }

        [MethodImpl(Kernel.Compiled)]
        private void Run(in Block block, in Wrench load, bool isTurned)
        {
            VectorLanes gain = new VectorLanes(_dt * (load.Force / _mass.Mass + _gravity)), center = new VectorLanes(_mass.CenterOfMass);
            for (int i = 0; i < block.Rows; i += Lanes.Count)
            {
                Group bodies = block.At(i);
                VectorLanes x = new VectorLanes(bodies, X), v = new VectorLanes(bodies, V);
                if (_canMove)
                {
                    v += gain;
                    x += _dt * v;
                    Decay.By(_linearDecay, v).Write(bodies, V);
                }

                if (_canTurn || _isOffCenter)
                {
                    QuaternionLanes q = new QuaternionLanes(bodies, Q), oldQ = q;
                    if (_canTurn)
                        Turn(bodies, ref q, load, isTurned);

                    if (_isOffCenter)
                        x = x + oldQ.Rotate(center) - q.Rotate(center);
                }

                x.Write(bodies, X);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Turn(in Group bodies, ref QuaternionLanes q, in Wrench load, bool isTurned)
        {
            VectorLanes w = new VectorLanes(bodies, W);
            if (isTurned)
            {
                VectorLanes torque = new VectorLanes(load.Torque);
                torque = load.BodyTorque.IsZero ? torque : torque + q.Rotate(new VectorLanes(load.BodyTorque));
                w += _dt * Answer(_lab.UnitRotation ? q.Normalized : q, torque);
            }

            q += new QuaternionLanes(Lanes.Zero, 0.5 * _dt * w) * q;
            q = _lab.Normalise ? q.Normalized : q;
            q.Write(bodies, Q);
            Decay.By(_angularDecay, w).Write(bodies, W);
        }

        /// <summary>I⁻¹ τ with I = R I_ref Rᵀ, as <see cref="SymmetricMatrix3"/> computes it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private VectorLanes Answer(QuaternionLanes q, VectorLanes torque)
        {
            Lanes one = Lanes.One, two = new Lanes(2);
            Lanes qxx = q.X * q.X, qyy = q.Y * q.Y, qzz = q.Z * q.Z, qxy = q.X * q.Y, qxz = q.X * q.Z, qyz = q.Y * q.Z;
            Lanes qwx = q.W * q.X, qwy = q.W * q.Y, qwz = q.W * q.Z;
            VectorLanes row1 = new VectorLanes(one - two * (qyy + qzz), two * (qxy - qwz), two * (qxz + qwy));
            VectorLanes row2 = new VectorLanes(two * (qxy + qwz), one - two * (qxx + qzz), two * (qyz - qwx));
            VectorLanes row3 = new VectorLanes(two * (qxz - qwy), two * (qyz + qwx), one - two * (qxx + qyy));
            VectorLanes a1 = Inertia(row1), a2 = Inertia(row2), a3 = Inertia(row3);
            Lanes xx = VectorLanes.Dot(row1, a1), yy = VectorLanes.Dot(row2, a2), zz = VectorLanes.Dot(row3, a3);
            Lanes yz = VectorLanes.Dot(row2, a3), xz = VectorLanes.Dot(row1, a3), xy = VectorLanes.Dot(row1, a2);

            Lanes cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
            Lanes s = one / (xx * cxx + xy * cxy + xz * cxz);
            Lanes ixx = s * cxx, iyy = s * (xx * zz - xz * xz), izz = s * (xx * yy - xy * xy);
            Lanes iyz = s * (xy * xz - xx * yz), ixz = s * cxz, ixy = s * cxy;
            return new VectorLanes(
                ixx * torque.X + ixy * torque.Y + ixz * torque.Z,
                ixy * torque.X + iyy * torque.Y + iyz * torque.Z,
                ixz * torque.X + iyz * torque.Y + izz * torque.Z);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private VectorLanes Inertia(VectorLanes v)
        {
            SymmetricMatrix3 a = _mass.Inertia;
            Lanes xx = new Lanes(a.Diagonal.X), yy = new Lanes(a.Diagonal.Y), zz = new Lanes(a.Diagonal.Z);
            Lanes yz = new Lanes(a.OffDiagonal.X), xz = new Lanes(a.OffDiagonal.Y), xy = new Lanes(a.OffDiagonal.Z);
            return new VectorLanes(xx * v.X + xy * v.Y + xz * v.Z, xy * v.X + yy * v.Y + yz * v.Z, xz * v.X + yz * v.Y + zz * v.Z);
        }
    }
}
#endif
