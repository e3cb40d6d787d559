using System;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The lab's script: five steps, in its order. It has no gyroscopic term, so with three different moments it
    /// conserves ω, not L, and converges to the motion of a real body only where the moments are equal.
    /// </summary>
    internal partial struct LabEuler : IIntegrator
    {
        private BodyState _body;
        private MassProperties _mass;
        private LabSettings _lab;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt, _linearDecay, _angularDecay;
        private Vector3d _gravity;

        public BodyState State => _body;

        public bool IsAsleep => false;

        public bool IsFinite => _body.HasFiniteSquares;

        public bool HasClosedForm => !_canMove && !_canTurn;

        public void Start(in Beginning body)
        {
            _body = body.State;
            _mass = body.Mass;
            _lab = body.Lab;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !body.Mass.CenterOfMass.IsZero;
        }

        public void Push(in Wrench impulse)
        {
            // without LabSettings.Normalise the length of q is not 1
            BodyState pushed = _body;
            pushed.Orientation = pushed.Orientation.Normalized;
            pushed = impulse.AppliedTo(pushed, _mass);
            if (_canMove)
                _body.Velocity = pushed.Velocity;

            if (_canTurn)
                _body.AngularVelocity = pushed.AngularVelocity;
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _gravity = coasting.Acceleration;
            _linearDecay = coasting.LinearDecay(duration);
            _angularDecay = coasting.AngularDecay(duration);
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush =>
            Step(now, ref push, xFromOldVelocity: false);

        // the five formulas are below, in the sheet's order, component by component: with operators on vectors they take more than
        // twice as long on Mono, which runs Unity's editor
        internal void Step<TPush>(in Instant now, ref TPush push, bool xFromOldVelocity) where TPush : struct, IPush
        {
            Wrench load;
            load.Force = load.Torque = load.BodyTorque = new Vector3d(0, 0, 0);
            push.At(now, _body, _mass, ref load);
            // formula 3 as printed in the handout
            if (xFromOldVelocity && _canMove)
                UpdatePosition();

            if (_canMove)
                UpdateVelocity(load);

            if (_canTurn && (push.Traits & EffectTraits.Turns) != 0)
                UpdateAngularVelocity(ref load);

            if (!xFromOldVelocity && _canMove)
                UpdatePosition();

            // x is the centre of mass; the origin of the body frame rotates about it
            if (_isOffCenter)
                _body.Position += _body.Orientation.Rotate(_mass.CenterOfMass);

            if (_canTurn && _lab.FirstOrderOrientation)
                UpdateOrientation();
            else if (_canTurn)
                TurnByWholeAngle();

            if (_isOffCenter)
                _body.Position -= _body.Orientation.Rotate(_mass.CenterOfMass);

            Damp();
        }

        // 1. v = v + Δt (F / m + g)
        private void UpdateVelocity(in Wrench load)
        {
            double dt = _dt, m = _mass.Mass;
            _body.Velocity.X += dt * (load.Force.X / m + _gravity.X);
            _body.Velocity.Y += dt * (load.Force.Y / m + _gravity.Y);
            _body.Velocity.Z += dt * (load.Force.Z / m + _gravity.Z);
        }

        // 2. ω = ω + Δt I⁻¹ τ with I = R I_ref Rᵀ
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void UpdateAngularVelocity(ref Wrench load)
        {
            // R of q
            Quaterniond q = _lab.UnitRotation ? _body.Orientation.Normalized : _body.Orientation;
            double wx = q.W * q.X, wy = q.W * q.Y, wz = q.W * q.Z;
            double xx = q.X * q.X, yy = q.Y * q.Y, zz = q.Z * q.Z, xy = q.X * q.Y, xz = q.X * q.Z, yz = q.Y * q.Z;
            double r11 = 1 - 2 * (yy + zz), r12 = 2 * (xy - wz), r13 = 2 * (xz + wy);
            double r21 = 2 * (xy + wz), r22 = 1 - 2 * (xx + zz), r23 = 2 * (yz - wx);
            double r31 = 2 * (xz - wy), r32 = 2 * (yz + wx), r33 = 1 - 2 * (xx + yy);

            // A = I_ref Rᵀ, column by column
            Vector3d d = _mass.Inertia.Diagonal, o = _mass.Inertia.OffDiagonal;
            double a11 = d.X * r11 + o.Z * r12 + o.Y * r13, a21 = o.Z * r11 + d.Y * r12 + o.X * r13, a31 = o.Y * r11 + o.X * r12 + d.Z * r13;
            double a12 = d.X * r21 + o.Z * r22 + o.Y * r23, a22 = o.Z * r21 + d.Y * r22 + o.X * r23, a32 = o.Y * r21 + o.X * r22 + d.Z * r23;
            double a13 = d.X * r31 + o.Z * r32 + o.Y * r33, a23 = o.Z * r31 + d.Y * r32 + o.X * r33, a33 = o.Y * r31 + o.X * r32 + d.Z * r33;

            // I = R A
            double i11 = r11 * a11 + r12 * a21 + r13 * a31, i12 = r11 * a12 + r12 * a22 + r13 * a32;
            double i22 = r21 * a12 + r22 * a22 + r23 * a32, i23 = r21 * a13 + r22 * a23 + r23 * a33;
            double i33 = r31 * a13 + r32 * a23 + r33 * a33, i13 = r11 * a13 + r12 * a23 + r13 * a33;

            // I⁻¹ = C / det I, with C the cofactors of I
            double c11 = i22 * i33 - i23 * i23, c12 = i13 * i23 - i12 * i33, c13 = i12 * i23 - i13 * i22;
            double c22 = i11 * i33 - i13 * i13, c23 = i12 * i13 - i11 * i23, c33 = i11 * i22 - i12 * i12;
            double s = 1 / (i11 * c11 + i12 * c12 + i13 * c13);

            Vector3d t = load.TorqueInWorld(_body.Orientation);
            _body.AngularVelocity.X += _dt * (s * c11 * t.X + s * c12 * t.Y + s * c13 * t.Z);
            _body.AngularVelocity.Y += _dt * (s * c12 * t.X + s * c22 * t.Y + s * c23 * t.Z);
            _body.AngularVelocity.Z += _dt * (s * c13 * t.X + s * c23 * t.Y + s * c33 * t.Z);
        }

        // 3. x = x + Δt v
        private void UpdatePosition()
        {
            double dt = _dt;
            _body.Position.X += dt * _body.Velocity.X;
            _body.Position.Y += dt * _body.Velocity.Y;
            _body.Position.Z += dt * _body.Velocity.Z;
        }

        // 4. q = q + [0, ½ Δt ω] q, then back to length 1
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void UpdateOrientation()
        {
            double h = 0.5 * _dt, hx = h * _body.AngularVelocity.X, hy = h * _body.AngularVelocity.Y, hz = h * _body.AngularVelocity.Z;
            Quaterniond q = _body.Orientation;
            double w = q.W - (hx * q.X + hy * q.Y + hz * q.Z);
            double x = q.X + (hx * q.W + hy * q.Z - hz * q.Y);
            double y = q.Y + (hy * q.W + hz * q.X - hx * q.Z);
            double z = q.Z + (hz * q.W + hx * q.Y - hy * q.X);
            double s = _lab.Normalise ? 1 / Math.Sqrt(w * w + x * x + y * y + z * z) : 1;
            _body.Orientation.W = s * w;
            _body.Orientation.X = s * x;
            _body.Orientation.Y = s * y;
            _body.Orientation.Z = s * z;
        }

        // 5. v = 0.98 v and ω = 0.98 ω, or the damping of the scene
        private void Damp()
        {
            if (_linearDecay != 1)
            {
                _body.Velocity.X = Decay.By(_linearDecay, _body.Velocity.X);
                _body.Velocity.Y = Decay.By(_linearDecay, _body.Velocity.Y);
                _body.Velocity.Z = Decay.By(_linearDecay, _body.Velocity.Z);
            }

            if (_angularDecay != 1)
            {
                _body.AngularVelocity.X = Decay.By(_angularDecay, _body.AngularVelocity.X);
                _body.AngularVelocity.Y = Decay.By(_angularDecay, _body.AngularVelocity.Y);
                _body.AngularVelocity.Z = Decay.By(_angularDecay, _body.AngularVelocity.Z);
            }
        }

        // 4, by the whole angle ω Δt
        private void TurnByWholeAngle()
        {
            Quaterniond q = _body.Orientation;
            q = q + SmallTurn.Of(_body.AngularVelocity, _body.AngularVelocity.Length, _dt) * q;
            _body.Orientation = _lab.Normalise ? q.Normalized : q;
        }
    }
}
