using System;

namespace RigidBodyDynamics
{
    /// <summary>The settings of Unity's Rigidbody, with Unity's defaults. For <c>UnityRigidbody</c> only.</summary>
    public sealed class UnitySettings
    {
        private double _drag;
        private double _angularDrag = 0.05;
        private double _maxAngularVelocity = 7;
        private double _sleepThreshold = 0.005;
        private double _wakeCounter = 0.4;

        /// <summary>Rigidbody.drag, 1/s: v times max(0, 1 − drag Δt) in each step.</summary>
        public double Drag { get => _drag; set => _drag = Guard.NotNegative(value, "drag"); }

        /// <summary>Rigidbody.angularDrag, 1/s: ω times max(0, 1 − angularDrag Δt) in each step.</summary>
        public double AngularDrag { get => _angularDrag; set => _angularDrag = Guard.NotNegative(value, "angularDrag"); }

        /// <summary>Rigidbody.maxAngularVelocity, rad/s; infinite for no limit.</summary>
        public double MaxAngularVelocity
        {
            get => _maxAngularVelocity;
            set => _maxAngularVelocity = value >= 0 ? value : throw Guard.Refused("maxAngularVelocity", value, "must not be below zero");
        }

        /// <summary>Rigidbody.sleepThreshold, J/kg; zero for a body that never sleeps.</summary>
        public double SleepThreshold { get => _sleepThreshold; set => _sleepThreshold = Guard.NotNegative(value, "sleepThreshold"); }

        /// <summary>How long a body at rest stays awake at the start, s.</summary>
        public double WakeCounter { get => _wakeCounter; set => _wakeCounter = Guard.NotNegative(value, "wakeCounter"); }

        /// <summary>PhysX 5's gyroscopic forces. Unity 2019.4 has none.</summary>
        public bool GyroscopicForces { get; set; }

        /// <summary>Compute in double instead of Unity's float.</summary>
        public bool InDouble { get; set; }

        /// <summary>The lab's q + [0, ½ Δt ω] q in place of the exact rotation: only to show the effect of that formula.</summary>
        public bool FirstOrderOrientation { get; set; }

        /// <summary>
        /// Moments from <c>Rigidbody.inertiaTensor</c>, which has 0 for a frozen axis: that moment becomes the largest of the others,
        /// or 1, and the axis is locked.
        /// </summary>
        public static Vector3d Moments(Vector3d inertiaTensor, out Locks frozen)
        {
            Vector3d i = Guard.Finite(inertiaTensor, nameof(inertiaTensor));
            double largest = Math.Max(i.X, Math.Max(i.Y, i.Z)), other = largest > 0 ? largest : 1;
            frozen = (i.X == 0 ? Locks.TurnX : 0) | (i.Y == 0 ? Locks.TurnY : 0) | (i.Z == 0 ? Locks.TurnZ : 0);
            return new Vector3d(i.X == 0 ? other : i.X, i.Y == 0 ? other : i.Y, i.Z == 0 ? other : i.Z);
        }

        /// <summary>A separate copy of the settings.</summary>
        public UnitySettings Copy() => (UnitySettings)MemberwiseClone();
    }
}
