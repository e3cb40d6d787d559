using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>Members whose names differ between versions of Unity, in one place.</summary>
    internal static class EngineVersions
    {
        /// <summary>The velocity of the centre of mass, m/s.</summary>
        public static Vector3 Velocity(Rigidbody body)
        {
#if UNITY_6000_0_OR_NEWER
            return body.linearVelocity;
#else
            return body.velocity;
#endif
        }

        /// <summary>Sets the velocity of the centre of mass, m/s.</summary>
        public static void SetVelocity(Rigidbody body, Vector3 velocity)
        {
#if UNITY_6000_0_OR_NEWER
            body.linearVelocity = velocity;
#else
            body.velocity = velocity;
#endif
        }

        /// <summary>Sets the drag of the velocity and that of the angular velocity, 1/s.</summary>
        public static void SetDrag(Rigidbody body, float drag, float angularDrag)
        {
#if UNITY_6000_0_OR_NEWER
            body.linearDamping = drag;
            body.angularDamping = angularDrag;
#else
            body.drag = drag;
            body.angularDrag = angularDrag;
#endif
        }

        /// <summary>The drag of the velocity, 1/s.</summary>
        public static float Drag(Rigidbody body)
        {
#if UNITY_6000_0_OR_NEWER
            return body.linearDamping;
#else
            return body.drag;
#endif
        }

        /// <summary>The drag of the angular velocity, 1/s.</summary>
        public static float AngularDrag(Rigidbody body)
        {
#if UNITY_6000_0_OR_NEWER
            return body.angularDamping;
#else
            return body.angularDrag;
#endif
        }

        /// <summary>True where the engine steps its physics after each FixedUpdate, as it does unless a script has changed that.</summary>
        public static bool StepsPhysicsItself
        {
            get
            {
#if UNITY_2022_2_OR_NEWER
                return Physics.simulationMode == SimulationMode.FixedUpdate;
#else
                return Physics.autoSimulation;
#endif
            }
        }

        /// <summary>One step of the engine's physics while the game is paused.</summary>
        public static void StepPhysics()
        {
#if UNITY_2022_2_OR_NEWER
            SimulationMode before = Physics.simulationMode;
            Physics.simulationMode = SimulationMode.Script;
            Physics.Simulate(Time.fixedDeltaTime);
            Physics.simulationMode = before;
#else
            bool before = Physics.autoSimulation;
            Physics.autoSimulation = false;
            Physics.Simulate(Time.fixedDeltaTime);
            Physics.autoSimulation = before;
#endif
        }
    }
}
