using System;

namespace RigidBodyDynamics
{
    /// <summary>How an integrator of order 1 computes ω under the gyroscopic torque −ω × I ω.</summary>
    internal interface IGyroscopicRule
    {
        /// <summary>ω after a step under that torque alone; principal axes, rad/s. Moments in any unit.</summary>
        Vector3d After(Vector3d w, Vector3d moments, double dt);
    }

    /// <summary>
    /// One Newton step for implicit Euler, I (ω₊ − ω) + Δt ω₊ × I ω₊ = 0. Stable for any step length, because it dissipates energy.
    /// E. Catto, "Numerical Methods", GDC 2015.
    /// </summary>
    internal struct ImplicitRule : IGyroscopicRule
    {
        public Vector3d After(Vector3d w, Vector3d i, double dt)
        {
            Vector3d m = Vector3d.Scale(i, w), f = dt * Vector3d.Cross(w, m);
            // J = I + Δt ([ω]× I − [Iω]×), in which only differences of moments remain
            Vector3d r1 = new Vector3d(i.X, dt * w.Z * (i.Z - i.Y), dt * w.Y * (i.Z - i.Y));
            Vector3d r2 = new Vector3d(dt * w.Z * (i.X - i.Z), i.Y, dt * w.X * (i.X - i.Z));
            Vector3d r3 = new Vector3d(dt * w.Y * (i.Y - i.X), dt * w.X * (i.Y - i.X), i.Z);
            // Cramer's rule by rows: J⁻¹ f = (f₁ r₂×r₃ + f₂ r₃×r₁ + f₃ r₁×r₂) / det J
            Vector3d c1 = Vector3d.Cross(r2, r3), c2 = Vector3d.Cross(r3, r1), c3 = Vector3d.Cross(r1, r2);
            return w - (1 / Vector3d.Dot(r1, c1)) * (f.X * c1 + f.Y * c2 + f.Z * c3);
        }
    }

    /// <summary>
    /// Explicit Euler for M = I ω, then M scaled back to its length, as PhysX's gyroscopic option does. |L| is conserved, its
    /// direction and the energy are not.
    /// </summary>
    internal struct ExplicitRule : IGyroscopicRule
    {
        public Vector3d After(Vector3d w, Vector3d i, double dt)
        {
            Vector3d m = Vector3d.Scale(i, w), next = m - dt * Vector3d.Cross(w, m);
            double length = next.Length;
            next = length > 0 ? (m.Length / length) * next : next;
            return new Vector3d(next.X / i.X, next.Y / i.Y, next.Z / i.Z);
        }
    }

    /// <summary>
    /// A reference: the method of game engines. ω under the torque, then under the gyroscopic torque; the body rotates about the new
    /// ω by exactly |ω| Δt; x with the new velocity; damping. Order 1.
    /// </summary>
    internal struct GyroscopicEuler<TRule> : IIntegrator where TRule : struct, IGyroscopicRule
    {
        private BodyState _body;
        private MassProperties _mass;
        private PrincipalAxesOrder _axes;
        private Vector3d _ratios;
        private bool _canMove, _canTurn, _isOffCenter;
        private double _dt;
        private Coasting _coasting;
        private double _linearDecay, _angularDecay;

        public BodyState State => _body;

        public bool IsAsleep => false;

        public bool IsFinite => _body.HasFiniteSquares;

        public bool HasClosedForm => !_canMove && !_canTurn;

        public void Start(in Beginning body)
        {
            _body = body.State;
            _mass = body.Mass;
            _axes = new PrincipalAxesOrder(_mass, 0);
            // only ratios matter, and a product of three moments of 1e-120 would underflow to zero
            _ratios = (1 / Math.Max(_mass.PrincipalMoments.X, Math.Max(_mass.PrincipalMoments.Y, _mass.PrincipalMoments.Z))) * _mass.PrincipalMoments;
            _canMove = body.CanMove;
            _canTurn = body.CanTurn;
            _isOffCenter = !_mass.CenterOfMass.IsZero;
        }

        public void Push(in Wrench impulse)
        {
            BodyState pushed = impulse.AppliedTo(_body, _mass);
            if (_canMove)
                _body.Velocity = pushed.Velocity;

            if (_canTurn)
                _body.AngularVelocity = pushed.AngularVelocity;
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _coasting = coasting;
            _linearDecay = coasting.LinearDecay(duration);
            _angularDecay = coasting.AngularDecay(duration);
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            Wrench load = default(Wrench);
            push.At(now, _body, _mass, ref load);
            Quaterniond q = _body.Orientation, oldQ = q;
            Vector3d v = _body.Velocity, x = _body.Position;
            if (_canMove)
            {
                v = _linearDecay * (v + _dt * (_mass.InverseMass * load.Force + _coasting.Acceleration));
                x += _dt * v;
            }

            if (_canTurn)
            {
                Vector3d w = _axes.FromBody(q.RotateInverse(_body.AngularVelocity));
                if ((push.Traits & EffectTraits.Turns) != 0)
                    w += _dt * Vector3d.Scale(_mass.InversePrincipalMoments, _axes.FromBody(q.RotateInverse(load.TorqueInWorld(q))));

                w = default(TRule).After(w, _ratios, _dt);
                Vector3d world = _angularDecay * q.Rotate(_axes.ToBody(w));
                q = (q + SmallTurn.Of(world, world.Length, _dt) * q).Normalized;
                _body.AngularVelocity = world;
            }

            _body.Velocity = v;
            _body.Orientation = q;
            _body.Position = _isOffCenter ? x + oldQ.Rotate(_mass.CenterOfMass) - q.Rotate(_mass.CenterOfMass) : x;
        }
    }
}
