using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// Coroutines over many fixed steps. As in Unity one ends with its script and where its object is deactivated, but not where its
    /// script is disabled.
    /// </summary>
    internal static class Coroutines
    {
        private static readonly List<Coroutine> Running = new List<Coroutine>();

        public static Coroutine Start(MonoBehaviour owner, IEnumerator routine)
        {
            Coroutine started = new Coroutine(owner, routine);
            Running.Add(started);
            GoOn(started);
            return started;
        }

        public static void Stop(Coroutine routine) => Running.Remove(routine);

        /// <summary>The running routine of a script that was started with this enumerator; does nothing where there is none.</summary>
        public static void Stop(MonoBehaviour owner, IEnumerator routine) =>
            Running.RemoveAll(running => ReferenceEquals(running.Owner, owner) && ReferenceEquals(running.Routine, routine));

        public static void StopAll(MonoBehaviour owner) => Running.RemoveAll(routine => ReferenceEquals(routine.Owner, owner));

        public static void Reset() => Running.Clear();

        /// <summary>Called after a fixed step and the engine's physics.</summary>
        public static void AfterFixedStep()
        {
            Running.RemoveAll(routine => !routine.Owner || !routine.Owner.gameObject.activeInHierarchy);
            foreach (Coroutine routine in Running.ToArray())
            {
                if (Running.Contains(routine))
                    GoOn(routine);
            }
        }

        private static void GoOn(Coroutine routine)
        {
            try
            {
                if (!routine.Routine.MoveNext())
                    Stop(routine);
                else if (!(routine.Routine.Current is WaitForFixedUpdate))
                    throw MonoBehaviour.NotHere(nameof(MonoBehaviour.StartCoroutine));
            }
            catch (Exception)
            {
                Stop(routine);
                throw;
            }
        }
    }
}
