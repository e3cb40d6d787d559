using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    // members of a Rigidbody, with Unity's names and, unless stated otherwise, Unity's meaning
    public sealed partial class MyRigidbody
    {
        private bool _isAsleep;

        /// <summary>Velocity of the centre of mass, m/s, world axes. Can be set at any time.</summary>
        public Vector3 velocity
        {
            get => State.Velocity.Float();
            set => Set((ref BodyState state) => state.Velocity = value.Double());
        }

        /// <summary>The same, by its name in Unity 6.</summary>
        public Vector3 linearVelocity { get => velocity; set => velocity = value; }

        /// <summary>Angular velocity, rad/s, world axes. No limit of 7 rad/s.</summary>
        public Vector3 angularVelocity
        {
            get => State.AngularVelocity.Float();
            set => Set((ref BodyState state) => state.AngularVelocity = value.Double());
        }

        /// <summary>Position of the body, m; between two steps an interpolated object is drawn elsewhere.</summary>
        public Vector3 position
        {
            get => State.Position.Float();
            set => MovePosition(value);
        }

        /// <summary>Orientation of the body; between two steps an interpolated object is drawn in another one.</summary>
        public Quaternion rotation
        {
            get => State.Orientation.Float();
            set => MoveRotation(value);
        }

        /// <summary>Centre of mass, m, world axes.</summary>
        public Vector3 worldCenterOfMass => Center.Float();

        private Vector3d Center => State.Position + State.Orientation.Rotate(Body.Mass.CenterOfMass);

        private delegate void Change(ref BodyState state);

        /// <summary>
        /// Applies a force at the centre of mass. Force (N) and Acceleration (m/s²) act during the next step, Impulse (N s) and VelocityChange (m/s) at once.
        /// </summary>
        public void AddForce(Vector3 force, ForceMode mode = ForceMode.Force)
        {
            WakeUp();
            if (IsAtOnce(mode))
                Body.ApplyImpulse(Weight(mode) * force.Double());
            else
                Body.ApplyForce(Weight(mode) * force.Double());
        }

        /// <summary>Applies a force at a point of the world. Force and torque stay constant for the whole step.</summary>
        public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode = ForceMode.Force)
        {
            WakeUp();
            if (IsAtOnce(mode))
                Body.ApplyImpulse(Weight(mode) * force.Double(), position.Double());
            else
                Body.ApplyForce(Weight(mode) * force.Double(), position.Double());
        }

        /// <summary>Applies a force along the object's own axes, as they are now.</summary>
        public void AddRelativeForce(Vector3 force, ForceMode mode = ForceMode.Force) => AddForce(InWorld(force), mode);

        /// <summary>
        /// Applies a torque. Force (N m) and Acceleration (rad/s²) act during the next step, Impulse (N m s) and VelocityChange (rad/s) at once.
        /// </summary>
        public void AddTorque(Vector3 torque, ForceMode mode = ForceMode.Force)
        {
            WakeUp();
            Vector3d applied = mode == ForceMode.Acceleration || mode == ForceMode.VelocityChange ? Inertia(torque.Double()) : torque.Double();
            if (IsAtOnce(mode))
                Body.ApplyAngularImpulse(applied);
            else
                Body.ApplyTorque(applied);
        }

        /// <summary>Applies a torque about the object's own axes, as they are now.</summary>
        public void AddRelativeTorque(Vector3 torque, ForceMode mode = ForceMode.Force) => AddTorque(InWorld(torque), mode);

        /// <summary>Moves the body at once, with its velocity; there are no contacts on the way.</summary>
        public void MovePosition(Vector3 position)
        {
            BodyState state = State;
            state.Position = position.Double();
            Body.State = state;
            Show();
        }

        /// <summary>Rotates the body at once, with its angular velocity.</summary>
        public void MoveRotation(Quaternion rot)
        {
            BodyState state = State;
            state.Orientation = rot.Double().Normalized;
            Body.State = state;
            Show();
        }

        /// <summary>Velocity of the point of the body that is now at a point of the world, m/s.</summary>
        public Vector3 GetPointVelocity(Vector3 worldPoint) =>
            (State.Velocity + Vector3d.Cross(State.AngularVelocity, worldPoint.Double() - Center)).Float();

        /// <summary>Stops the body, and ignores all effects until it is woken: by WakeUp, a key, a force or a velocity.</summary>
        public void Sleep()
        {
            _isAsleep = true;
            Stand();
        }

        /// <summary>Effects act again.</summary>
        public void WakeUp() => _isAsleep = false;

        /// <summary>True from Sleep on until it is woken. Nothing else puts it to sleep.</summary>
        public bool IsSleeping() => _isAsleep;

        private void TakeStep()
        {
            if (_isAsleep && IsAnyKeyHeld())
                WakeUp();

            if (!_isAsleep)
            {
                StepOn();
                return;
            }

            // time passes for a sleeping body, too
            BodyState before = State;
            StepOn();
            Body.State = before;
        }

        // in every frame: the interpolated pose between the last two steps
        private void Update()
        {
            if (interpolation == RigidbodyInterpolation.None || !IsReady)
                return;

            float past = (Time.time - Time.fixedTime) / Time.fixedDeltaTime;
            Put(Body.Between(Mathf.Clamp01(past)));
        }

        private void Set(Change change)
        {
            WakeUp();
            BodyState state = State;
            change(ref state);
            Body.State = Held(state, Body.Mass);
        }

        private bool IsAnyKeyHeld()
        {
            bool isHeld = false;
            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
                isHeld |= _keyboard[key];

            return isHeld;
        }

        private void Stand()
        {
            BodyState state = State;
            state.Velocity = state.AngularVelocity = Vector3d.Zero;
            Body.State = state;
        }

        private static bool IsAtOnce(ForceMode mode) => mode == ForceMode.Impulse || mode == ForceMode.VelocityChange;

        private double Weight(ForceMode mode) => mode == ForceMode.Acceleration || mode == ForceMode.VelocityChange ? Body.Mass.Mass : 1;

        private Vector3 InWorld(Vector3 own) => State.Orientation.Rotate(own.Double()).Float();

        // Unity's numbers are twice the library's
        private Locks Locked => (Locks)((int)constraints / 2);

        // removes velocities along locked axes: those of the world for translation, the body's own for rotation
        private BodyState Held(BodyState state, MassProperties mass)
        {
            Quaterniond axes = (state.Orientation * mass.PrincipalFrame).Normalized;
            state.Velocity = Vector3d.Scale(Free(RigidbodyConstraints.FreezePositionX), state.Velocity);
            if ((constraints & RigidbodyConstraints.FreezeRotation) != 0)
                state.AngularVelocity = axes.Rotate(Vector3d.Scale(Free(RigidbodyConstraints.FreezeRotationX), axes.Conjugate.Rotate(state.AngularVelocity)));

            return state;
        }

        // 1 for a free axis; Unity's constraints are powers of two for x, y, z, from the first
        private Vector3d Free(RigidbodyConstraints first) => new Vector3d(IsFree(first, 0), IsFree(first, 1), IsFree(first, 2));

        private int IsFree(RigidbodyConstraints first, int axis) => ((int)constraints & ((int)first << axis)) == 0 ? 1 : 0;

        // I ω in the world
        private Vector3d Inertia(Vector3d spin)
        {
            Quaterniond axes = State.Orientation * Body.Mass.PrincipalFrame;
            return axes.Rotate(Vector3d.Scale(Body.Mass.PrincipalMoments, axes.Conjugate.Rotate(spin)));
        }
    }
}
