using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>The engine's physics. There are no contacts; <see cref="Touching"/> finds those that would be.</summary>
    public static class Physics
    {
        public static Vector3 gravity { get; set; }

        public static float sleepThreshold { get; set; }

#if UNITY_2022_2_OR_NEWER
        private const string Refused = "simulation mode is not set to Script. You should set simulation mode to Script first";

        public static SimulationMode simulationMode { get; set; }

        internal static bool IsAutomatic => simulationMode == SimulationMode.FixedUpdate;
#else
        private const string Refused = "auto simulation is active. You should disable auto simulation first";

        public static bool autoSimulation { get; set; }

        internal static bool IsAutomatic => autoSimulation;
#endif

        /// <summary>One step of all bodies, called by a script.</summary>
        public static void Simulate(float step)
        {
            if (IsAutomatic)
            {
                Debug.LogWarning("Physics.Simulate(...) was called but " + Refused + " before calling this function therefore the simulation was not run.");
                return;
            }

            Step(step);
        }

        /// <summary>Lets two colliders pass through each other.</summary>
        public static void IgnoreCollision(Collider collider1, Collider collider2) => IgnoreCollision(collider1, collider2, true);

        public static void IgnoreCollision(Collider collider1, Collider collider2, bool ignore) => Touching.Ignore(collider1, collider2, ignore);

        internal static void Step(float step)
        {
            foreach (GameObject holder in World.Objects.ToArray())
            {
                if (holder.activeInHierarchy)
                    holder.GetComponent<Rigidbody>()?.Step(step);
            }

            Touching.Look();
        }

        internal static void Reset()
        {
            gravity = new Vector3(0, -9.81f, 0);
            sleepThreshold = 0.005f;
            Touching.Reset();
#if UNITY_2022_2_OR_NEWER
            simulationMode = SimulationMode.FixedUpdate;
#else
            autoSimulation = true;
#endif
        }
    }

#if UNITY_2022_2_OR_NEWER
    /// <summary>When physics steps.</summary>
    public enum SimulationMode
    {
        FixedUpdate,
        Update,
        Script,
    }
#endif
}
