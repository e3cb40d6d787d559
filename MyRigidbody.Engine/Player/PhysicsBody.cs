using RigidBodyDynamics;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// The motion of a Rigidbody by UnityRigidbody, which repeats recorded PhysX motions bit for bit. A change by a script takes effect
    /// in the next step.
    /// </summary>
    internal sealed class PhysicsBody
    {
        // the wake counter of a body that PhysX has just woken, s
        private const double Awake = 0.4f;

        private UnityRigidbody<ToSingle> _rule;
        private bool _hasBegun, _isChanged = true;
        private double _wakeCounter = Awake;
        private Vector3 _force, _torque, _impulse, _seenPosition;
        private Quaternion _seenRotation;

        public Vector3 Position { get; private set; }

        public Quaternion Rotation { get; private set; }

        public Vector3 Velocity { get; private set; }

        public Vector3 AngularVelocity { get; private set; }

        public bool IsAsleep { get; private set; }

        /// <summary>Called when a setting has changed.</summary>
        public void Change() => _isChanged = true;

        /// <summary>Sets the first pose.</summary>
        public void Begin(Vector3 position, Quaternion rotation)
        {
            if (_hasBegun)
                return;

            MoveTo(position, rotation);
            _seenPosition = position;
            _seenRotation = rotation;
        }

        /// <summary>Takes over the pose of the object if a script has changed it.</summary>
        public void Follow(Vector3 position, Quaternion rotation)
        {
            bool isMoved = !position.Equals(_seenPosition) || !rotation.Equals(_seenRotation);
            _seenPosition = position;
            _seenRotation = rotation;
            if (isMoved && !(position.Equals(Position) && rotation.Equals(Rotation)))
                MoveTo(position, rotation);
        }

        public void MoveTo(Vector3 position, Quaternion rotation)
        {
            Position = position;
            Rotation = rotation;
            _hasBegun = _isChanged = true;
        }

        public void SetVelocities(Vector3 velocity, Vector3 angularVelocity)
        {
            Velocity = velocity;
            AngularVelocity = angularVelocity;
            WakeUp();
        }

        /// <summary>Adds force and torque for the next step only.</summary>
        public void Push(Vector3 force, Vector3 torque)
        {
            _force += force;
            _torque += torque;
        }

        /// <summary>Adds an impulse, N s, for the next step, whatever its length.</summary>
        public void Kick(Vector3 impulse) => _impulse += impulse;

        /// <summary>Drops forces and impulses added since the last step.</summary>
        public void ForgetPushes() => _force = _torque = _impulse = Vector3.zero;

        public void WakeUp()
        {
            IsAsleep = false;
            _wakeCounter = Awake;
            _isChanged = true;
        }

        public void Sleep()
        {
            ForgetPushes();
            Velocity = AngularVelocity = Vector3.zero;
            IsAsleep = true;
            _wakeCounter = 0;
            _isChanged = true;
        }

        public void Step(float step, BodyDescription body, Vector3 gravity)
        {
            if (_isChanged)
            {
                body.Start = new BodyState(Position.Exact(), Rotation.Exact(), Velocity.Exact(), AngularVelocity.Exact());
                body.Unity.WakeCounter = _wakeCounter;
                _rule.Start(new Beginning(body));
                _isChanged = false;
            }

            Coasting coasting = Coasting.Free;
            coasting.Acceleration = gravity.Exact();
            Pushed push = new Pushed((_force + _impulse * (1 / step)).Exact(), _torque.Exact());
            _rule.Prepare(step, coasting);
            _rule.Step(default(Instant), ref push);
            ForgetPushes();

            BodyState now = _rule.State;
            Position = now.Position.Rounded();
            Rotation = now.Orientation.Rounded();
            Velocity = now.Velocity.Rounded();
            AngularVelocity = now.AngularVelocity.Rounded();
            IsAsleep = _rule.IsAsleep;
            _wakeCounter = _rule.WakeCounter;
        }

        /// <summary>The forces and torques of scripts in one step.</summary>
        private readonly struct Pushed : IPush
        {
            private readonly Vector3d _force, _torque;

            public Pushed(Vector3d force, Vector3d torque)
            {
                _force = Guard.Finite(force, nameof(force));
                _torque = Guard.Finite(torque, nameof(torque));
            }

            public EffectTraits Traits => EffectTraits.Moves | EffectTraits.Turns;

            public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

            public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
            {
                impulse.Force += duration * _force;
                impulse.Torque += duration * _torque;
            }
        }
    }

    /// <summary>Conversions between the engine's numbers and the library's.</summary>
    internal static class Conversions
    {
        public static Vector3d Exact(this Vector3 v) => new Vector3d(v.x, v.y, v.z);

        public static Quaterniond Exact(this Quaternion q) => new Quaterniond(q.w, q.x, q.y, q.z);

        public static Vector3 Rounded(this Vector3d v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        public static Quaternion Rounded(this Quaterniond q) => new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
    }
}
