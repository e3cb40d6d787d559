using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// What goes on over many fixed steps. As in Unity it ends with its script and where its object is switched off, and not where its
    /// script is.
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

        /// <summary>By what it was started with; nothing where this script runs no such thing.</summary>
        public static void Stop(MonoBehaviour owner, IEnumerator routine) =>
            Running.RemoveAll(running => ReferenceEquals(running.Owner, owner) && ReferenceEquals(running.Routine, routine));

        public static void StopAll(MonoBehaviour owner) => Running.RemoveAll(routine => ReferenceEquals(routine.Owner, owner));

        public static void Reset() => Running.Clear();

        /// <summary>A fixed step is done, the engine's physics too.</summary>
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
