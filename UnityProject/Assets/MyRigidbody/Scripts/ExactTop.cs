using System;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// The exact rotation of a body that an engine moves. PhysX rotates a body in each step with its angular velocity, constant during
    /// the step; so before the step the body gets the angular velocity that takes it to the orientation of the free top after the step,
    /// and after the step any change by the engine (contacts, joints, torques) goes into the free top as an angular impulse.
    /// Between two steps the engine has the top's true angular velocity.
    /// </summary>
    /// <remarks>It uses no engine, so that the same lines run in Unity, on the stand-in and against PhysX itself.</remarks>
    internal sealed class ExactTop
    {
        // the rounding of an angular velocity and of an orientation by the engine's float arithmetic in a step: on PhysX 5.6
        // nothing, 5.8e-8 with drag, and 1.7e-7
        private const double VelocityRounding = 2e-6, TurnRounding = 4e-6;
        // rad: where the engine has rotated a body this far from the top, I has changed, and conserving L would create energy
        private const double HardBlow = 0.01;

        private Simulation _simulation;
        private MassProperties _mass;
        private Calm _calm;
        private EngineBody _made;
        private double _madeFor, _keep;
        private BodyState _before, _now;
        private Vector3d _given, _seenVelocity;
        private Quaterniond _seenOrientation;
        private bool _isNeeded, _isInStep, _isPushed;

        /// <summary>False where the engine's own motion is right: the body sleeps or soon will, or has no gyroscopic term.</summary>
        public bool IsFollowing { get; private set; }

        /// <summary>The top after the last step. Only its orientation and angular velocity are meaningful.</summary>
        public BodyState State => _now;

        /// <summary>For 1 kg: free rotation does not depend on the mass.</summary>
        public MassProperties Mass => _mass;

        private Body Top => _simulation.Bodies[0];

        /// <summary>Called before a step of the engine.</summary>
        /// <param name="body">The present body.</param>
        /// <param name="step">The step in the engine, s.</param>
        /// <returns>The angular velocity to set, of numbers that fit a float; null for no change.</returns>
        public Vector3d? Before(in EngineBody body, float step)
        {
            if (_isInStep)
                After(body);

            if (_simulation == null || step != _madeFor || !body.IsLike(_made))
                Make(body, step);

            if (!_isNeeded || body.IsAsleep || _calm.Look(body, _mass.Inertia, step, _isPushed))
            {
                IsFollowing = false;
                return null;
            }

            Take(body);
            _before = _now;
            Advance();
            _isInStep = true;
            _given = Rounded(Mean(_now.Orientation * body.Orientation.Normalized.Conjugate, _before.AngularVelocity, step) / _keep);
            return Change(body.AngularVelocity, _given);
        }

        /// <summary>Called after the engine's step, before any script changes the body.</summary>
        /// <returns>The true angular velocity to set, of numbers that fit a float; null for no change.</returns>
        public Vector3d? After(in EngineBody body)
        {
            if (!_isInStep)
                return null;

            _isInStep = false;
            if (body.IsAsleep)
            {
                IsFollowing = false;
                return null;
            }

            Vector3d left = _keep * _given, change = body.AngularVelocity - left;
            _isPushed = change.Length > VelocityRounding * left.Length;
            if (_isPushed)
                Push(change / _keep);

            // the engine's orientation is kept: a velocity that corrects it would count as momentum at the next contact
            Quaterniond orientation = body.Orientation.Normalized;
            double off = Conserved.AngleBetween(orientation, _now.Orientation);
            if (_isPushed || off > TurnRounding)
                Set(orientation, off < HardBlow ? AngularVelocity(orientation, Conserved.AngularMomentum(_now, _mass)) : _now.AngularVelocity);

            _seenOrientation = body.Orientation;
            _seenVelocity = Rounded(_now.AngularVelocity);
            return Change(body.AngularVelocity, _seenVelocity);
        }

        /// <summary>Forgets the motion: the next step begins with the engine's state.</summary>
        public void Forget() => IsFollowing = _isInStep = false;

        private void Make(in EngineBody body, float step)
        {
            _made = body;
            _madeFor = step;
            _mass = body.MassProperties(out Locks frozen);
            _keep = Math.Max(0, 1 - (float)body.AngularDrag * step);
            // with a locked axis no gyroscopic term is left: the engine's motion is right
            _isNeeded = !_mass.IsIsotropic && frozen == Locks.None && _keep > 0;
            BodyDescription top = new BodyDescription("top", _mass) { Rule = Rules.Exact };
            double time = (double)(decimal)step;
            if (_keep > 0 && _keep < 1)
                top.With(new AngularDamping(-Math.Log(_keep) / time));

            _simulation = new Simulation(TimeSteps.Every(time), top);
            if (IsFollowing)
                Top.State = _now;
        }

        /// <summary>Takes over what a script has set since the last step.</summary>
        private void Take(in EngineBody body)
        {
            bool isPlaced = !IsFollowing || body.Orientation != _seenOrientation, isSpun = !IsFollowing || body.AngularVelocity != _seenVelocity;
            if (isPlaced || isSpun)
                Set(isPlaced ? body.Orientation.Normalized : _now.Orientation, isSpun ? body.AngularVelocity : _now.AngularVelocity);

            _seenOrientation = body.Orientation;
            IsFollowing = true;
        }

        private void Set(Quaterniond orientation, Vector3d angularVelocity)
        {
            _now = new BodyState(Vector3d.Zero, orientation, Vector3d.Zero, angularVelocity);
            Top.State = _now;
        }

        /// <summary>The engine has applied an impulse at the beginning of the step: applies it here, and repeats the step.</summary>
        private void Push(Vector3d change)
        {
            Top.State = _before;
            Top.ApplyAngularImpulse(Conserved.AngularMomentum(new BodyState(Vector3d.Zero, _seenOrientation, Vector3d.Zero, change), _mass));
            Advance();
        }

        private void Advance()
        {
            _simulation.Step();
            _now = Top.State;
        }

        private Vector3d AngularVelocity(Quaterniond orientation, Vector3d momentum)
        {
            Quaterniond principal = (orientation * _mass.PrincipalFrame).Normalized;
            return principal.Rotate(Vector3d.Scale(_mass.InversePrincipalMoments, principal.RotateInverse(momentum)));
        }

        /// <summary>The angular velocity that makes a rotation in a time; of rotations that differ by whole revolutions, the nearest to that of ω.</summary>
        private static Vector3d Mean(Quaterniond turn, Vector3d angularVelocity, double time)
        {
            double sine = turn.Vector.Length;
            if (sine == 0)
                return angularVelocity;

            double angle = 2 * Math.Atan2(sine, turn.W), along = Vector3d.Dot(angularVelocity, turn.Vector) / sine * time;
            angle += 2 * Math.PI * Math.Round((along - angle) / (2 * Math.PI));
            return angle / (sine * time) * turn.Vector;
        }

        private static Vector3d? Change(Vector3d from, Vector3d to) => from == to ? (Vector3d?)null : to;

        private static Vector3d Rounded(Vector3d v) => new Vector3d((float)v.X, (float)v.Y, (float)v.Z);
    }
}
