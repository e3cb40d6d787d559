using System;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// The exact rotation of a body that an engine moves. PhysX turns a body in each of its steps by its angular velocity, which stays
    /// as it is for the step; so before the step it is given the angular velocity that takes it to where the free top is afterwards,
    /// and after the step what the engine has changed (contacts, joints, torques) goes into the free top as an angular impulse.
    /// Between two steps the engine has the top's true angular velocity.
    /// </summary>
    /// <remarks>It knows no engine, so that the same lines run in Unity, on the stand-in and against PhysX itself.</remarks>
    internal sealed class ExactTop
    {
        // what float arithmetic in the engine does to an angular velocity and to an orientation in a step: on PhysX 5.6
        // nothing, 5.8e-8 with drag, and 1.7e-7
        private const double VelocityRounding = 2e-6, TurnRounding = 4e-6;
        // rad: where the engine has turned a body that far from the top, I is another, and L kept would be energy made
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

        /// <summary>False while the engine's own motion is left alone: the body sleeps or soon will, or has no gyroscopic term.</summary>
        public bool IsFollowing { get; private set; }

        /// <summary>The top after the last step. Only its orientation and angular velocity mean anything.</summary>
        public BodyState State => _now;

        /// <summary>Of 1 kg: how the body turns does not depend on its mass.</summary>
        public MassProperties Mass => _mass;

        private Body Top => _simulation.Bodies[0];

        /// <summary>To be called before a step of the engine.</summary>
        /// <param name="body">The body as it is.</param>
        /// <param name="step">The step, s, as the engine counts it.</param>
        /// <returns>The angular velocity to be set, of numbers that fit a float; null if it is to be left as it is.</returns>
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

        /// <summary>To be called after the engine's step, before any script changes the body.</summary>
        /// <returns>The true angular velocity to be set, of numbers that fit a float; null if it is to be left as it is.</returns>
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

            // the engine's place holds: a velocity to catch up by would be taken for momentum at the next contact
            Quaterniond orientation = body.Orientation.Normalized;
            double off = Conserved.AngleBetween(orientation, _now.Orientation);
            if (_isPushed || off > TurnRounding)
                Set(orientation, off < HardBlow ? AngularVelocity(orientation, Conserved.AngularMomentum(_now, _mass)) : _now.AngularVelocity);

            _seenOrientation = body.Orientation;
            _seenVelocity = Rounded(_now.AngularVelocity);
            return Change(body.AngularVelocity, _seenVelocity);
        }

        /// <summary>Forgets the motion: the next step begins with what the engine then has.</summary>
        public void Forget() => IsFollowing = _isInStep = false;

        private void Make(in EngineBody body, float step)
        {
            _made = body;
            _madeFor = step;
            _mass = body.MassProperties(out Locks frozen);
            _keep = Math.Max(0, 1 - (float)body.AngularDrag * step);
            // with an axis frozen no gyroscopic term is left: the engine is right by itself
            _isNeeded = !_mass.IsIsotropic && frozen == Locks.None && _keep > 0;
            BodyDescription top = new BodyDescription("top", _mass) { Rule = Rules.Exact };
            double time = (double)(decimal)step;
            if (_keep > 0 && _keep < 1)
                top.With(new AngularDamping(-Math.Log(_keep) / time));

            _simulation = new Simulation(TimeSteps.Every(time), top);
            if (IsFollowing)
                Top.State = _now;
        }

        /// <summary>What somebody has set since the last step holds.</summary>
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

        /// <summary>The engine has given a push at the beginning of the step: so is it given here, and the step taken again.</summary>
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

        /// <summary>The angular velocity that makes a turn in a time; of turns that differ by whole ones, the nearest to what ω makes.</summary>
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
