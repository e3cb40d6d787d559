using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>The engine's physics. Nothing touches here.</summary>
    public static class Physics
    {
        public static Vector3 gravity { get; set; }

        public static float sleepThreshold { get; set; }

#if UNITY_2022_2_OR_NEWER
        public static SimulationMode simulationMode { get; set; }

        internal static bool IsAutomatic => simulationMode == SimulationMode.FixedUpdate;
#else
        public static bool autoSimulation { get; set; }

        internal static bool IsAutomatic => autoSimulation;
#endif

        /// <summary>One step of all bodies, by a script.</summary>
        public static void Simulate(float step)
        {
            if (IsAutomatic)
            {
                Debug.LogWarning("Physics.Simulate(...) was called but simulation mode is not set to Script. You should set simulation mode to Script first before calling this function therefore the simulation was not run.");
                return;
            }

            Step(step);
        }

        internal static void Step(float step)
        {
            foreach (GameObject holder in World.Objects.ToArray())
            {
                if (holder.activeInHierarchy)
                    holder.GetComponent<Rigidbody>()?.Step(step);
            }
        }

        internal static void Reset()
        {
            gravity = new Vector3(0, -9.81f, 0);
            sleepThreshold = 0.005f;
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
