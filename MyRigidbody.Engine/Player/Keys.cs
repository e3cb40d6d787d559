using System;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>The keyboard. Keys change between frames.</summary>
    public static class Keys
    {
        private static readonly HashSet<KeyCode> Down = new HashSet<KeyCode>(), Begun = new HashSet<KeyCode>(), Ended = new HashSet<KeyCode>();
        private static readonly List<(KeyCode Key, bool IsDown)> Changes = new List<(KeyCode, bool)>();

        /// <summary>Called when a script reads a key, before the answer.</summary>
        internal static Action<KeyCode> Asked { get; set; }

        internal static bool IsAnyDown => Down.Count > 0;

        internal static bool HasAnyBegun => Begun.Count > 0;

        /// <summary>Presses or releases a key.</summary>
        public static void Hold(KeyCode key, bool isDown)
        {
            if (!(isDown ? Down.Add(key) : Down.Remove(key)))
                return;

            Changes.Add((key, isDown));
            (isDown ? Begun : Ended).Add(key);
        }

        internal static bool IsDown(KeyCode key) => Ask(Down, key);

        /// <summary>True in the frame in which it was pressed.</summary>
        internal static bool HasBegun(KeyCode key) => Ask(Begun, key);

        /// <summary>True in the frame in which it was released.</summary>
        internal static bool HasEnded(KeyCode key) => Ask(Ended, key);

        internal static void EndFrame()
        {
            Begun.Clear();
            Ended.Clear();
        }

        internal static void Reset()
        {
            Asked = null;
            Down.Clear();
            Changes.Clear();
            EndFrame();
        }

        /// <summary>The changes since the last call.</summary>
        internal static (KeyCode Key, bool IsDown)[] TakeChanges()
        {
            (KeyCode, bool)[] taken = Changes.ToArray();
            Changes.Clear();
            return taken;
        }

        private static bool Ask(HashSet<KeyCode> keys, KeyCode key)
        {
            Asked?.Invoke(key);
            return keys.Contains(key);
        }
    }
}
