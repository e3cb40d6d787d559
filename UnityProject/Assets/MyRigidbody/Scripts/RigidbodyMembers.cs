using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    // what scripts expect of a Rigidbody, in Unity's names and with Unity's meaning where nothing else is said
    public sealed partial class MyRigidbody
    {
        private bool _isAsleep;

        /// <summary>Velocity of the centre of mass, m/s, world axes. To be set at any time.</summary>
        public Vector3 velocity
        {
            get => State.Velocity.Float();
            set => Set((ref BodyState state) => state.Velocity = value.Double());
        }

        /// <summary>The same, as Unity 6 calls it.</summary>
        public Vector3 linearVelocity { get => velocity; set => velocity = value; }

        /// <summary>Angular velocity, rad/s, world axes. No limit of 7 rad/s.</summary>
        public Vector3 angularVelocity
        {
            get => State.AngularVelocity.Float();
            set => Set((ref BodyState state) => state.AngularVelocity = value.Double());
        }

        /// <summary>Where the body is, m; the object is drawn elsewhere between two steps if it is interpolated.</summary>
        public Vector3 position
        {
            get => State.Position.Float();
            set => MovePosition(value);
        }

        /// <summary>How the body is turned; the object is drawn otherwise between two steps if it is interpolated.</summary>
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
        /// Pushes at the centre of mass. Force (N) and Acceleration (m/s²) act during the next step, Impulse (N s) and VelocityChange (m/s) at once.
        /// </summary>
        public void AddForce(Vector3 force, ForceMode mode = ForceMode.Force)
        {
            WakeUp();
            if (IsAtOnce(mode))
                Body.ApplyImpulse(Weight(mode) * force.Double());
            else
                Body.ApplyForce(Weight(mode) * force.Double());
        }

        /// <summary>Pushes at a point of the world. Force and torque stay as they are now for the whole step.</summary>
        public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode = ForceMode.Force)
        {
            WakeUp();
            if (IsAtOnce(mode))
                Body.ApplyImpulse(Weight(mode) * force.Double(), position.Double());
            else
                Body.ApplyForce(Weight(mode) * force.Double(), position.Double());
        }

        /// <summary>Pushes along the object's own axes, as they are now.</summary>
        public void AddRelativeForce(Vector3 force, ForceMode mode = ForceMode.Force) => AddForce(InWorld(force), mode);

        /// <summary>
        /// Turns. Force (N m) and Acceleration (rad/s²) act during the next step, Impulse (N m s) and VelocityChange (rad/s) at once.
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

        /// <summary>Turns about the object's own axes, as they are now.</summary>
        public void AddRelativeTorque(Vector3 torque, ForceMode mode = ForceMode.Force) => AddTorque(InWorld(torque), mode);

        /// <summary>Puts the body elsewhere at once, with its velocity; what is in between is not touched.</summary>
        public void MovePosition(Vector3 position)
        {
            BodyState state = State;
            state.Position = position.Double();
            Body.State = state;
            Show();
        }

        /// <summary>Turns the body at once, with its angular velocity.</summary>
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

        /// <summary>Stands still, and feels nothing until it is woken: by WakeUp, a key, a push or a velocity.</summary>
        public void Sleep()
        {
            _isAsleep = true;
            Stand();
        }

        /// <summary>Feels again what acts on it.</summary>
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

            // time goes on for who sleeps, too
            BodyState before = State;
            StepOn();
            Body.State = before;
        }

        // every frame: the pose between the last two steps, as far as the frame is past the last of them
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

        // a frozen body loses what it has along the axes that are frozen: those of the world for moving, its own for turning
        private BodyState Held(BodyState state, MassProperties mass)
        {
            Quaterniond axes = (state.Orientation * mass.PrincipalFrame).Normalized;
            state.Velocity = Vector3d.Scale(Free(RigidbodyConstraints.FreezePositionX), state.Velocity);
            if ((constraints & RigidbodyConstraints.FreezeRotation) != 0)
                state.AngularVelocity = axes.Rotate(Vector3d.Scale(Free(RigidbodyConstraints.FreezeRotationX), axes.Conjugate.Rotate(state.AngularVelocity)));

            return state;
        }

        // 1 for an axis that is free; Unity counts x, y, z in powers of two, from the first
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
